"""The exposure's margin in words: how far the LEDs are from too dim and from clipping."""

from host_tool.cli.output import number
from host_tool.contract.blocks import Camera, Health


def margin_of(camera: Camera) -> str:
    """Both factors, 1.0 = at the limit, and what to do beyond it."""
    if camera.above_dim is None or camera.below_clipping is None:
        return "no LED seen: margin of the exposure unknown"
    words = f"LED {_factor(camera.above_dim)} above dim, {_factor(camera.below_clipping)} below clipping"
    if camera.above_dim < 1.0:
        return f"{words}: TOO DIM, expose longer"
    if camera.below_clipping <= 1.0:
        return f"{words}: TOO BRIGHT, expose shorter"
    return words


def margins_of(health: Health) -> list[str]:
    """A line for each camera."""
    return [f"left: {margin_of(health.left)}", f"right: {margin_of(health.right)}"]


def _factor(value: float) -> str:
    return f"{number(value, 1 if value < 10.0 else 0)}x"
