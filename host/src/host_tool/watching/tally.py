"""Adding up what was seen, into the figures of a summary."""

import math
from dataclasses import dataclass

from host_tool.watching.follow import Sighting
from host_tool.watching.truth import Comparison


@dataclass(frozen=True, slots=True)
class Summary:
    """Figures over the sightings counted. Shares are of 1; None where nothing was there to divide by."""

    seconds: float
    verdicts: int
    missed: int
    poses: int
    rate_hz: float | None  # verdicts the unit brought per second, missed ones included
    valid_share: float | None
    inside_share: float | None
    rms_mm: float | None
    worst_mm: float | None
    turned_rms_deg: float | None = None  # of the orientation; None also for a target without one
    turned_worst_deg: float | None = None


class Tally:
    """Grows by one sighting at a time; needs constant memory however long it runs."""

    def __init__(self) -> None:
        self._first_s: float | None = None
        self._last_s = 0.0
        self._verdicts = self._missed = self._poses = self._compared = self._inside = 0
        self._squares_mm2 = self._worst_mm = 0.0
        self._turned = 0
        self._squares_deg2 = self._worst_deg = 0.0

    def add(self, sighting: Sighting, comparison: Comparison | None) -> None:
        """Counts a fresh verdict; a repeat only moves the time on. What was missed before the first is not ours."""
        if self._first_s is None:
            self._first_s = sighting.at_s
        else:
            self._missed += sighting.missed
        self._last_s = sighting.at_s
        if not sighting.fresh:
            return
        self._verdicts += 1
        self._poses += sighting.answer.pose.position_valid
        if comparison is not None:
            self._compared += 1
            self._inside += comparison.inside
            self._squares_mm2 += comparison.error_mm**2
            self._worst_mm = max(self._worst_mm, comparison.error_mm)
        if comparison is not None and comparison.turned_deg is not None:
            self._turned += 1
            self._squares_deg2 += comparison.turned_deg**2
            self._worst_deg = max(self._worst_deg, comparison.turned_deg)

    def summary(self) -> Summary:
        """The figures so far."""
        seconds = self._last_s - self._first_s if self._first_s is not None else 0.0
        steps = self._verdicts + self._missed - 1  # between first and last verdict
        return Summary(
            seconds=seconds,
            verdicts=self._verdicts,
            missed=self._missed,
            poses=self._poses,
            rate_hz=steps / seconds if seconds > 0.0 else None,
            valid_share=self._poses / self._verdicts if self._verdicts else None,
            inside_share=self._inside / self._compared if self._compared else None,
            rms_mm=math.sqrt(self._squares_mm2 / self._compared) if self._compared else None,
            worst_mm=self._worst_mm if self._compared else None,
            turned_rms_deg=math.sqrt(self._squares_deg2 / self._turned) if self._turned else None,
            turned_worst_deg=self._worst_deg if self._turned else None,
        )
