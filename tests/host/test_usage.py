"""A wrong command line is refused with a code, what failed and what to do; an output that fails is said."""

import itertools
import subprocess
import sys

import pytest
from host.fake_unit import fake_unit
from host.register_image import measuring_image

from host_tool.cli.main import run
from host_tool.errors import ExitCode

PROGRAM = (sys.executable, "-c", "from host_tool.cli.main import main; main()")
ROWS = ("simulate", "scout")


@pytest.mark.parametrize(
    ("arguments", "begins", "ends"),
    [
        ((), "E-USE-03 host-tool: no command is named", "write one of status, watch, plc, simulate, demo"),
        (("plc",), "E-USE-03 host-tool plc: no command is named", "write one of export, probe"),
        (("nonsense",), "E-USE-03 host-tool: no such command 'nonsense'", "simulate, demo"),
        (("--nonsense",), "E-USE-04 host-tool: no such option '--nonsense'", "--help lists what it takes"),
        (("watch", "--cont"), "E-USE-04 host-tool watch: no such option '--cont' (did you mean", "takes"),
        (("status", "more"), "E-USE-04 host-tool status: got unexpected extra argument (more)", "takes"),
        (("watch", "--count"), "E-USE-05 host-tool watch: option '--count' requires an argument", "takes"),
        (("simulate",), "E-USE-05 host-tool simulate: missing argument 'SCENARIO'", "takes"),
        (("watch", "--count", "0"), "E-USE-06 host-tool watch: invalid value for '--count': 0", "takes"),
        (("watch", "--seconds", "nan"), "E-USE-06 host-tool watch: invalid value for '--seconds': nan", "takes"),
        (("plc", "export", "--format", "s7"), "E-USE-06 host-tool plc export: invalid value for '--format'", "takes"),
        (("plc", "export", "--out", "x"), "E-PLC-02 no format is named", "siemens, beckhoff, codesys, rockwell, ur"),
        (("plc", "probe", "--base", "7"), "E-USE-06 host-tool plc probe: invalid value for '--base'", "takes"),
    ],
)
def test_a_wrong_command_line_says_in_one_line_what_to_do(
    arguments: tuple[str, ...], begins: str, ends: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(arguments) == ExitCode.USAGE
    out, err = capsys.readouterr()
    assert out == ""
    (line,) = err.splitlines()
    assert line.startswith(begins)
    assert line.endswith(ends)


@pytest.mark.parametrize("arguments", [ROWS, (*ROWS, "--json"), ("--help",), ("--version",)])
def test_a_full_output_is_said_and_is_no_success(arguments: tuple[str, ...]) -> None:
    with open("/dev/full", "w") as full:  # noqa: PTH123
        ended = subprocess.run([*PROGRAM, *arguments], stdout=full, stderr=subprocess.PIPE, text=True, check=False)
    assert ended.returncode == ExitCode.USAGE
    (line,) = ended.stderr.splitlines()
    assert line.startswith("E-OUT-01 the output cannot be written (No space left on device)")


def test_a_closed_pipe_ends_quietly() -> None:
    sequence = itertools.count(1)
    with fake_unit(lambda: measuring_image(next(sequence))) as unit:
        command = [*PROGRAM, "watch", "--seconds", "30", "--device", unit.device]
        with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as program:
            assert program.stdout is not None
            assert program.stderr is not None
            assert "mm" in program.stdout.readline()
            program.stdout.close()
            assert program.stderr.read() == ""
    assert program.returncode == ExitCode.INTERRUPTED


@pytest.mark.parametrize("command", [(), ("status",), ("watch",), ("plc",), ("plc", "probe"), ("simulate",), ("demo",)])
def test_every_help_has_an_example(command: tuple[str, ...], capsys: pytest.CaptureFixture[str]) -> None:
    assert run([*command, "--help"]) == ExitCode.PASS
    assert "Example: host-tool " in capsys.readouterr().out
