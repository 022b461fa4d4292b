"""What click finds wrong with a command line, as our own errors: a code, what failed, what to do."""

from collections.abc import Sequence
from typing import cast

import click

from host_tool.errors import UsageError


def usage_error_from(error: click.ClickException, arguments: Sequence[str], program: click.Group) -> UsageError:
    """E-USE-03 command, E-USE-04 unknown option or argument, E-USE-05 one is missing, E-USE-06 its value."""
    path, command = _named(arguments, program)
    if isinstance(command, click.Group) and not isinstance(error, click.NoSuchOption):
        return UsageError("E-USE-03", f"{path}: {_what(error)}", f"write one of {', '.join(command.commands)}")
    return UsageError(_code_of(error), f"{path}: {_what(error)}", f"{path} --help lists what it takes")


def _code_of(error: click.ClickException) -> str:
    if isinstance(error, (click.MissingParameter, click.BadOptionUsage)):
        return "E-USE-05"
    return "E-USE-06" if isinstance(error, click.BadParameter) else "E-USE-04"


def _what(error: click.ClickException) -> str:
    """Click's sentence in one line, without the capital and the full stop; a whole help text is no sentence."""
    words = " ".join(error.format_message().split()).replace(". (Did", " (did").rstrip(".")
    if not words or words.startswith("Usage:"):
        return "no command is named"
    return words[0].lower() + words[1:]


def _named(arguments: Sequence[str], program: click.Group) -> tuple[str, click.Command]:
    """The command that the words lead to, with its full name."""
    path, command = "host-tool", cast(click.Command, program)
    for word in arguments:
        if isinstance(command, click.Group) and word in command.commands:
            path, command = f"{path} {word}", command.commands[word]
    return path, command
