"""Everything that host-tool refuses to go on with: a code, what happened, what to do, and an exit code."""

from enum import IntEnum
from typing import ClassVar


class ExitCode(IntEnum):
    """What the shell gets; documented in docs/reference/host-tool.md."""

    PASS = 0
    FAILED = 1  # measured, and the verdict is no
    USAGE = 2
    NO_DEVICE = 3  # no device, or it refused
    INCONCLUSIVE = 4
    INTERRUPTED = 5
    OUR_FAULT = 70


class HostToolError(Exception):
    """Base of all expected failures. A subclass says where it belongs by `exit_code`."""

    exit_code: ClassVar[ExitCode] = ExitCode.OUR_FAULT

    def __init__(self, code: str, what: str, remedy: str) -> None:
        super().__init__(f"{code} {what}: {remedy}")
        self.code = code
        self.what = what
        self.remedy = remedy


class UsageError(HostToolError):
    """The command line or a file given on it cannot be used (E-USE, E-TRJ)."""

    exit_code = ExitCode.USAGE


class DeviceError(HostToolError):
    """No unit answers, it refuses, or it is not one we understand (E-NET, E-DEV)."""

    exit_code = ExitCode.NO_DEVICE


class InconclusiveError(HostToolError):
    """Measured, but not enough to give a verdict (E-INC)."""

    exit_code = ExitCode.INCONCLUSIVE
