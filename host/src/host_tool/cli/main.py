"""The command `host-tool`: the one place where failures become messages and exit codes."""

import errno
import os
import sys
from collections.abc import Sequence
from contextlib import suppress

import click

from host_tool import __version__
from host_tool.cli.complaint import usage_error_from
from host_tool.cli.demo import demo
from host_tool.cli.plc import plc
from host_tool.cli.simulate import simulate
from host_tool.cli.status import status
from host_tool.cli.watch import watch
from host_tool.errors import ExitCode, HostToolError


@click.group(
    context_settings={"help_option_names": ["-h", "--help"]},
    epilog="Exit codes: 0 pass, 1 measured and failed, 2 usage, 3 no device or it refused, 4 inconclusive, "
    "5 interrupted, 70 our fault.\n\nExample: host-tool status --device 192.168.1.20:502",
)
@click.version_option(__version__)
def host_tool() -> None:
    """Commission, watch and check a Tripoint stereo measuring unit.

    Data goes to stdout, messages to stderr. The unit is not a safety function.
    """


for command in (status, watch, plc, simulate, demo):
    host_tool.add_command(command)


def run(arguments: Sequence[str]) -> int:
    """Runs one command line and returns its exit code; never lets a traceback through."""
    try:
        code = host_tool.main(list(arguments), prog_name="host-tool", standalone_mode=False)
        click.echo("", nl=False)  # writes what is still in the buffer
    except HostToolError as error:
        return _refused(error)
    except click.ClickException as error:
        return _refused(usage_error_from(error, arguments, host_tool))
    except (click.Abort, KeyboardInterrupt):
        _say("interrupted")
        return ExitCode.INTERRUPTED
    except (OSError, SystemExit) as error:  # click turns a closed pipe into SystemExit
        return _unheard(error)
    except Exception as error:
        if os.environ.get("HOST_TOOL_DEBUG"):
            raise
        _say(f"E-BUG-01 {type(error).__name__} ({error}): our fault; please report it with what HOST_TOOL_DEBUG=1 adds")
        return ExitCode.OUR_FAULT
    return int(code or ExitCode.PASS)


def _refused(error: HostToolError) -> int:
    _say(str(error))
    return error.exit_code


def _unheard(error: OSError | SystemExit) -> int:
    """Our output cannot be written. Whoever closed the pipe has had enough: that needs no words."""
    # What is still in the buffer goes nowhere, so that the interpreter does not complain when it flushes at exit.
    os.dup2(os.open(os.devnull, os.O_WRONLY), 1)
    if isinstance(error, OSError) and error.errno != errno.EPIPE:
        _say(f"E-OUT-01 the output cannot be written ({error.strerror}): make room there, or send it elsewhere")
        return ExitCode.USAGE
    return ExitCode.INTERRUPTED


def _say(message: str) -> None:
    with suppress(OSError):  # a message that nobody can read changes nothing
        click.echo(message, err=True)


def main() -> None:
    """Entry point."""
    sys.exit(run(sys.argv[1:]))
