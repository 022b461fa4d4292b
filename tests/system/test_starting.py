"""Starting, refusing to start, and stopping."""

import os
import re
import shutil
import signal
import subprocess
import time
from contextlib import suppress
from pathlib import Path

import pytest
from system.daemon import (
    CONFIG,
    START_S,
    STOP_S,
    TIMEOUT_S,
    Daemon,
    binary,
    daemon,
    finished,
    free_port,
    renderer,
    tool,
)

from host_tool.appliance.address import Address
from host_tool.appliance.modbus import ModbusLink, Table
from host_tool.appliance.unit import open_unit, wait_until_answering
from host_tool.clock import MonotonicClock
from host_tool.errors import DeviceError

STATE = 36
STOPPED = 6
SLOWEST_CLIENT_S = 0.1  # docs/reference/registers.md: a request every 20 to 100 ms


@pytest.fixture
def broken(tmp_path: Path) -> Path:
    """A copy of the demo's configuration to damage, beside links to the files it names."""
    binary()  # skips where there is none
    for file in CONFIG.parent.iterdir():
        (tmp_path / file.name).symlink_to(file)
    copy = tmp_path / "broken.toml"
    copy.write_text(CONFIG.read_text(encoding="utf-8"), encoding="utf-8")
    return copy


def real_time_threads(running: Daemon) -> int:
    threads = [int(task.name) for task in Path(f"/proc/{running.process.pid}/task").iterdir()]
    return sum(os.sched_getscheduler(each) == os.SCHED_FIFO for each in threads)


def test_the_threads_that_are_waited_for_have_real_time_priority(tmp_path: Path) -> None:
    try:
        os.sched_setscheduler(0, os.SCHED_FIFO, os.sched_param(1))
        os.sched_setscheduler(0, os.SCHED_OTHER, os.sched_param(0))
    except PermissionError:
        pytest.skip("real-time priority is not permitted here")
    with daemon(tmp_path / "log") as unit:
        urgent = real_time_threads(unit)
    assert urgent == 2, "measuring and Modbus, and no camera: detection may take as long as a picture"
    assert "real-time priority" not in (tmp_path / "log").read_text(encoding="utf-8")


def test_where_real_time_priority_is_not_permitted_the_unit_measures_and_the_log_says_what_to_grant(
    tmp_path: Path,
) -> None:
    deprived: tuple[str, ...] = (tool("prlimit"), "--rtprio=0")
    if os.geteuid() == 0:  # who may do everything unless it is taken away
        deprived += (tool("setpriv"), "--bounding-set=-sys_nice", "--inh-caps=-sys_nice")
    with daemon(tmp_path / "log", through=deprived) as running, open_unit(running.address, TIMEOUT_S) as unit:
        deadline_s = time.monotonic() + START_S
        while unit.read_pose().pose.position_mm is None:
            assert time.monotonic() < deadline_s
        assert real_time_threads(running) == 0
    log = (tmp_path / "log").read_text(encoding="utf-8")
    for thread in ("modbus", "measuring"):
        assert f"{thread}: no real-time priority" in log
    assert "grant LimitRTPRIO or CAP_SYS_NICE" in log


@pytest.mark.parametrize("processor", ["qemu64", "Nehalem"])
def test_a_processor_that_is_too_old_is_refused_with_a_sentence(processor: str) -> None:
    """qemu64 has SSE3, as the processors of 2005; Nehalem is the oldest of x86-64-v2."""
    emulator = shutil.which("qemu-x86_64")
    if emulator is None:
        pytest.skip("qemu-user is not installed")
    for program in (binary(), renderer()):
        ran = subprocess.run(
            [emulator, "-cpu", processor, program, "--help"],
            capture_output=True,
            text=True,
            timeout=TIMEOUT_S,
            check=False,
        )
        assert ran.returncode == (2 if processor == "qemu64" else 0)
        assert ("older than x86-64-v2" in ran.stderr) == (processor == "qemu64")


def test_the_demos_configuration_is_valid() -> None:
    checked = finished("check-config", str(CONFIG))
    assert checked.returncode == 0, checked.stderr


def test_an_unknown_key_is_named_with_its_line(broken: Path) -> None:
    text = broken.read_text(encoding="utf-8")
    line = text.splitlines().index("[modbus]") + 2
    broken.write_text(text.replace("[modbus]\n", "[modbus]\nprot = 1503\n"), encoding="utf-8")
    for command in (("check-config", str(broken)), ("run", "--config", str(broken))):
        checked = finished(*command)
        assert checked.returncode == 2
        assert "modbus.prot" in checked.stderr
        assert f"{broken.name}:{line}" in checked.stderr


def test_a_value_out_of_range_is_named_with_its_range() -> None:
    checked = finished("check-config", str(CONFIG), "--set", "modbus.port=70000")
    assert checked.returncode == 2
    assert "modbus.port" in checked.stderr
    assert "65535" in checked.stderr


@pytest.mark.parametrize("command", [("check-config",), ("run", "--config")])
def test_spheres_are_not_measured(command: tuple[str, ...]) -> None:
    refused = finished(*command, str(CONFIG), "--set", "detector.kind=sphere")
    assert refused.returncode == 2
    assert "detector.kind" in refused.stderr
    assert '"sphere" is for single pictures' in refused.stderr
    assert 'set "led"' in refused.stderr


def test_a_missing_table_is_named(broken: Path) -> None:
    text = broken.read_text(encoding="utf-8")
    broken.write_text(text.replace("[volume]", "[volumen]"), encoding="utf-8")
    checked = finished("check-config", str(broken))
    assert checked.returncode == 2
    assert "volume" in checked.stderr


def test_a_file_that_is_no_toml_is_refused_with_its_line(broken: Path) -> None:
    broken.write_text("[modbus\n", encoding="utf-8")
    checked = finished("check-config", str(broken))
    assert checked.returncode == 2
    assert f"{broken.name}:1" in checked.stderr


def test_a_missing_file_is_refused(tmp_path: Path) -> None:
    checked = finished("run", "--config", str(tmp_path / "none.toml"))
    assert checked.returncode == 2
    assert "none.toml" in checked.stderr


def test_a_port_in_use_ends_the_second(tmp_path: Path) -> None:
    with daemon(tmp_path / "log") as first:
        second = finished("run", "--config", str(CONFIG), "--set", f"modbus.port={first.port}")
    assert second.returncode == 2
    assert str(first.port) in second.stderr


@pytest.mark.parametrize("number", [signal.SIGTERM, signal.SIGINT])
def test_a_signal_ends_it_well_within_a_second(tmp_path: Path, number: signal.Signals) -> None:
    with daemon(tmp_path / "log") as running:
        started_s = time.monotonic()
        running.process.send_signal(number)
        assert running.process.wait(timeout=10.0 * STOP_S) == 0
        assert time.monotonic() - started_s < STOP_S


def test_a_stopping_unit_can_be_read_long_enough_for_its_slowest_client(tmp_path: Path) -> None:
    stopped_s = []
    with daemon(tmp_path / "log") as running, ModbusLink(running.address, TIMEOUT_S) as link:
        running.process.terminate()
        with suppress(DeviceError):
            while True:
                if link.read(Table.INPUT, STATE, 1) == (STOPPED,):
                    stopped_s.append(time.monotonic())
    assert stopped_s
    assert stopped_s[-1] - stopped_s[0] > SLOWEST_CLIENT_S


@pytest.mark.parametrize("arguments", [(), ("run",), ("measure",), ("run", "--config")])
def test_a_wrong_command_line_is_a_usage_error(arguments: tuple[str, ...]) -> None:
    assert finished(*arguments).returncode == 2


def test_an_unknown_subcommand_is_named_with_those_there_are() -> None:
    refused = finished("measure", "--config", str(CONFIG))
    assert refused.returncode == 2
    assert refused.stderr == (
        "tripointd: 'measure' is no subcommand: write one of run, check-config, cameras, expose, snapshot, detect, "
        "replay, version; `tripointd --help` explains them\n"
    )


def test_an_option_before_the_subcommand_is_told_its_place() -> None:
    refused = finished("--json", "cameras")
    assert refused.returncode == 2
    assert refused.stderr == "tripointd: --json stands before the subcommand: write `tripointd cameras --json`\n"
    assert finished("--json").stderr.startswith("tripointd: a subcommand is missing: write one of run,")


def test_a_missing_option_is_named_with_its_subcommand() -> None:
    refused = finished("run")
    assert refused.returncode == 2
    assert refused.stderr.startswith("tripointd run: --config is required;")


def test_the_version_is_told() -> None:
    told = finished("version")
    assert told.returncode == 0
    assert told.stdout.startswith("tripointd ")


@pytest.mark.parametrize("arguments", [("version",), ("--help",), ("check-config", str(CONFIG))])
def test_a_full_output_is_said_and_is_no_success(arguments: tuple[str, ...]) -> None:
    with open("/dev/full", "w") as full:  # noqa: PTH123
        ended = subprocess.run([binary(), *arguments], stdout=full, stderr=subprocess.PIPE, text=True, check=False)
    assert ended.returncode == 2
    assert ended.stderr.startswith("tripointd: the output cannot be written")


@pytest.mark.parametrize("command", [(), ("run",), ("check-config",), ("cameras",), ("detect",), ("replay",)])
def test_every_help_has_an_example(command: tuple[str, ...]) -> None:
    told = finished(*command, "--help")
    assert told.returncode == 0
    assert "Example: tripointd " in told.stdout


def test_the_setup_is_told_as_a_plc_sees_it_and_in_hex() -> None:
    setup = re.search(r"setup (\d+) \(0x([0-9A-F]{4})\)", finished("check-config", str(CONFIG)).stdout)
    assert setup is not None
    assert int(setup[1]) == int(setup[2], 16)


def test_a_log_that_nobody_reads_stops_nothing() -> None:
    reader, writer = os.pipe()
    os.set_blocking(writer, False)
    with suppress(BlockingIOError):
        while True:
            os.write(writer, bytes(4096))
    os.set_blocking(writer, True)
    port = free_port()
    command = [binary(), "run", "--config", str(CONFIG), "--set", f"modbus.port={port}"]
    process = subprocess.Popen(command, stderr=writer)
    try:
        wait_until_answering(Address("127.0.0.1", port), TIMEOUT_S, START_S, MonotonicClock())
        process.terminate()
        assert process.wait(timeout=10.0 * STOP_S) == 0
    finally:
        process.kill()
        process.wait()
        os.close(reader)
        os.close(writer)
