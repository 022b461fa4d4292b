"""Time as a thing that is passed in."""

import time
from typing import Protocol


class Clock(Protocol):
    """Time passed in, so that tests need none."""

    def now_s(self) -> float: ...

    def sleep(self, seconds: float) -> None: ...


class MonotonicClock:
    """The clock of this computer."""

    def now_s(self) -> float:
        return time.monotonic()

    def sleep(self, seconds: float) -> None:
        time.sleep(seconds)
