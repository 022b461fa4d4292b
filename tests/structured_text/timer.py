"""The standard's on-delay timer, and the time that the runtime runs on."""

from __future__ import annotations

from dataclasses import dataclass, field

from structured_text.values import Value


@dataclass(slots=True)
class Clock:
    """Milliseconds since the PLC started; the test moves it."""

    now_ms: int = 0


@dataclass(slots=True)
class Timer:
    """TON of IEC 61131-3: ET counts from the call in which IN was first TRUE, Q rises when it has reached PT."""

    type: str = "TON"
    members: dict[str, Value] = field(
        default_factory=lambda: {
            "in": Value("BOOL", False),
            "pt": Value("TIME", 0),
            "q": Value("BOOL", False),
            "et": Value("TIME", 0),
        }
    )
    started_ms: int | None = None

    def run(self, clock: Clock) -> None:
        """One call, its inputs being set."""
        if not self.members["in"].data:
            self.started_ms = None
        elif self.started_ms is None:
            self.started_ms = clock.now_ms
        elapsed_ms = 0 if self.started_ms is None else clock.now_ms - self.started_ms
        preset_ms = self.members["pt"].data
        self.members["et"] = Value("TIME", min(elapsed_ms, preset_ms))
        self.members["q"] = Value("BOOL", self.started_ms is not None and elapsed_ms >= preset_ms)
