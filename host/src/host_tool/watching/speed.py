"""How fast the target moves, from the poses themselves."""

import math
from collections import deque

from host_tool.contract.blocks import Pose, Triple

WINDOW_S = 0.3  # a chord this long averages the noise, and is still short against a robot's moves
_NS_PER_S = 1e9
_MOST_POSES = 64  # bound, whatever the rate


class Speedometer:
    """Mean speed along the chord from the oldest to the newest pose of the last WINDOW_S."""

    def __init__(self) -> None:
        self._seen: deque[tuple[int, Triple]] = deque(maxlen=_MOST_POSES)

    def take(self, pose: Pose) -> float | None:
        """mm/s; None until two valid poses exist, and after a pose without position."""
        if not pose.position_valid or pose.position_mm is None:
            self._seen.clear()
            return None
        if self._seen and pose.exposed_utc_ns <= self._seen[-1][0]:
            self._seen.clear()  # the unit restarted, or its clock was set back
        self._seen.append((pose.exposed_utc_ns, pose.position_mm))
        while pose.exposed_utc_ns - self._seen[0][0] > WINDOW_S * _NS_PER_S and len(self._seen) > 2:
            self._seen.popleft()
        then_ns, then_mm = self._seen[0]
        if then_ns == pose.exposed_utc_ns:
            return None
        return math.dist(then_mm, pose.position_mm) / ((pose.exposed_utc_ns - then_ns) / _NS_PER_S)
