"""The command `host-tool`: the one place where failures become messages and exit codes."""

import os
import sys
from collections.abc import Sequence

import click

from host_tool import __version__
from host_tool.cli.demo import demo
from host_tool.cli.plc import plc
from host_tool.cli.simulate import simulate
from host_tool.cli.status import status
from host_tool.cli.watch import watch
from host_tool.errors import ExitCode, HostToolError


@click.group(context_settings={"help_option_names": ["-h", "--help"]})
@click.version_option(__version__)
def host_tool() -> None:
    """Commission, watch and check a Tripoint stereo measuring unit."""


for command in (status, watch, plc, simulate, demo):
    host_tool.add_command(command)


def run(arguments: Sequence[str]) -> int:
    """Runs one command line and returns its exit code; never lets a traceback through."""
    try:
        code = host_tool.main(list(arguments), prog_name="host-tool", standalone_mode=False)
        sys.stdout.flush()
    except HostToolError as error:
        click.echo(str(error), err=True)
        return error.exit_code
    except click.ClickException as error:
        error.show()
        return ExitCode.USAGE
    except (click.Abort, KeyboardInterrupt):
        click.echo("interrupted", err=True)
        return ExitCode.INTERRUPTED
    except BrokenPipeError:
        # Whoever read our output has had enough; the interpreter must not complain when it flushes at exit.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return ExitCode.INTERRUPTED
    except Exception as error:
        if os.environ.get("HOST_TOOL_DEBUG"):
            raise
        click.echo(
            f"E-BUG-01 {type(error).__name__} ({error}): our fault; please report it with what HOST_TOOL_DEBUG=1 adds",
            err=True,
        )
        return ExitCode.OUR_FAULT
    return int(code or ExitCode.PASS)


def main() -> None:
    """Entry point."""
    sys.exit(run(sys.argv[1:]))
