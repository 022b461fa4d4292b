"""Whether the poses of a unit follow the truth, and know how well."""

from host_tool.watching.tally import Summary

LARGEST_RMS_MM = 1.0  # the paper's own figure at this distance; the stated uncertainty is far smaller


def assert_follows(figures: Summary, *, valid_share: float, inside_share: float) -> None:
    """At least these shares of verdicts have a pose, and of poses lie within what they state."""
    assert figures.valid_share is not None
    assert figures.valid_share >= valid_share
    assert figures.inside_share is not None
    assert figures.inside_share >= inside_share
    assert figures.rms_mm is not None
    assert figures.rms_mm < LARGEST_RMS_MM
