"""The verdict of `make demo`: is the measured position the true one, and does the unit know how good it is?"""

from dataclasses import dataclass

from host_tool.contract.blocks import Answer
from host_tool.contract.conditions import Status
from host_tool.errors import DeviceError, ExitCode
from host_tool.watching.tally import Summary

SETTLE_S = 5.0  # cameras start, clocks are learned; judged from here on
VALID_SHARE_MIN = 0.95
INSIDE_SHARE_MIN = 0.85  # k = 2 holds 95 % per axis, 87 % on all three at once
VERDICTS_MIN = 30  # about a second; fewer say nothing


@dataclass(frozen=True, slots=True)
class Verdict:
    """Exit code and, unless it is PASS, why."""

    exit_code: ExitCode
    reasons: tuple[str, ...] = ()


def verdict_on(summary: Summary) -> Verdict:
    """Judges what was seen after SETTLE_S."""
    if summary.verdicts < VERDICTS_MIN:
        few = f"only {summary.verdicts} verdicts after {SETTLE_S:g} s, need {VERDICTS_MIN}: run it longer"
        return Verdict(ExitCode.INCONCLUSIVE, (few,))
    valid, inside = summary.valid_share or 0.0, summary.inside_share or 0.0
    reasons = []
    if valid < VALID_SHARE_MIN:
        reasons.append(f"{valid:.1%} of the verdicts valid, need {VALID_SHARE_MIN:.0%}")
    if inside < INSIDE_SHARE_MIN:
        reasons.append(f"{inside:.1%} of the poses inside k = 2 on all axes, need {INSIDE_SHARE_MIN:.0%}")
    return Verdict(ExitCode.FAILED if reasons else ExitCode.PASS, tuple(reasons))


def exit_code_of(verdict: Verdict, endless: bool) -> ExitCode:
    """Ctrl-C is how an endless run ends: that it came too early for a verdict is no failure."""
    early = endless and verdict.exit_code is ExitCode.INCONCLUSIVE
    return ExitCode.PASS if early else verdict.exit_code


def check_simulated(answer: Answer) -> None:
    """Truth exists only in simulation: raises DeviceError E-DEM-01 on a unit that measures the real world."""
    if not answer.state.status & Status.SIMULATED:
        raise DeviceError(
            "E-DEM-01",
            "this unit measures real cameras, whose truth nobody knows",
            'start tripointd with cameras.source = "simulation", or use host-tool watch',
        )
