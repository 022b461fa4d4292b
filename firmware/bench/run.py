"""Measures every figure of the product and writes them as one JSON list; docs/reference/figures.md says what they are.

usage: run.py FOLDER_OF_PROGRAMS OUTPUT.json
Exits 1 when a figure misses its goal.
"""

from __future__ import annotations

import json
import socket
import struct
import subprocess
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import asdict, dataclass, replace
from pathlib import Path
from typing import Any

from instructions import in_function
from tables import SIZES, table, table_of_sizes

TOP = Path(__file__).parents[2]
WARM_UP_S = 25.0  # longer than the window of latencies that the unit keeps
LOAD_S = 20
SIZE_OF_GOALS = "640x480"
OF_FIRST_ROW = 4  # figures of bench_clutter


@dataclass(frozen=True, slots=True)
class Figure:
    name: str
    value: float
    unit: str
    goal: str | None
    reached: bool
    baseline: float | None = None
    ratio: float | None = None


def at_least(name: str, baseline: float, value: float, limit: float) -> Figure:
    """How many times less than the baseline."""
    ratio = baseline / value
    return Figure(name, ratio, "ratio", f">= {limit:g}", ratio >= limit, baseline, ratio)


def at_most(name: str, value: float, unit: str, limit: float) -> Figure:
    return Figure(name, value, unit, f"<= {limit:g}", value <= limit)


def of_program(program: Path, *arguments: str) -> list[dict[str, Any]]:
    """The figures that a benchmark program prints."""
    print(f"bench: {program.name} ...", file=sys.stderr, flush=True)
    run = subprocess.run([program, *arguments], stdout=subprocess.PIPE, check=True, text=True)
    figures: list[dict[str, Any]] = json.loads(run.stdout)
    return figures


def counted(name: str, program: Path, kind: str, size: str, goal: float) -> Figure:
    """What a stereo pair costs, in instructions, against the textbook."""
    ours, textbook = (in_function("*measured_pair*", program, each, size) for each in (kind, "textbook"))
    print(f"{name} {size}: {ours:.0f}, textbook {textbook:.0f}", file=sys.stderr, flush=True)
    if size == SIZE_OF_GOALS:
        return at_least(f"{name}_vs_textbook", textbook, ours, goal)
    return replace(at_least(f"{name}_{size}_vs_textbook", textbook, ours, 0), goal=None)


def of_a_spot(programs: Path) -> Figure:
    """From the area that the gates have left to the fitted centre."""
    instructions = in_function("*SpotMeasurer::measure(*", programs / "bench_pair", "spots", SIZE_OF_GOALS)
    return Figure("fit_instructions", instructions, "per spot", None, True)


def of_instructions(programs: Path) -> list[dict[str, Any]]:
    """Of whole YUYV pictures, of MJPEG around a forecast, and of measuring one spot."""
    print("bench: pairs under callgrind ...", file=sys.stderr, flush=True)
    figures = [counted("pair_instructions", programs / "bench_pair", "ours", size, 50) for size in SIZES]
    figures += [counted("pair_tracking_instructions", programs / "bench_mjpeg", "tracked", size, 60) for size in SIZES]
    return [asdict(figure) for figure in [*figures, of_a_spot(programs)]]


def free_port() -> int:
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        port: int = probe.getsockname()[1]
        return port


@contextmanager
def running_unit(tripointd: Path, port: int) -> Iterator[subprocess.Popen[bytes]]:
    """tripointd on two simulated 640x480 cameras, both processors busy with rendering and measuring."""
    configuration = TOP / "deploy/demo/demo.toml"
    command = [str(tripointd), "run", "--config", str(configuration), "--set", f"modbus.port={port}"]
    unit = subprocess.Popen(command, stderr=subprocess.DEVNULL)
    try:
        yield unit
    finally:
        unit.terminate()
        unit.wait(timeout=10)


def input_registers(port: int, address: int, count: int) -> bytes:
    """One FC 4 request; the answer's registers as big-endian bytes."""
    with socket.create_connection(("127.0.0.1", port), timeout=5) as connection:
        connection.sendall(struct.pack(">HHHBBHH", 1, 0, 6, 1, 4, address, count))
        answer = b""
        while len(answer) < 9 + 2 * count:
            received = connection.recv(512)
            if not received:
                raise ConnectionError("the unit closed the connection")
            answer += received
    return answer[9:]


def resident_mb(pid: int) -> float:
    for line in Path(f"/proc/{pid}/status").read_text().splitlines():
        if line.startswith("VmHWM:"):
            return float(line.split()[1]) / 1024
    raise LookupError("no VmHWM in the status of the process")


def of_the_unit(programs: Path) -> list[dict[str, Any]]:
    """What only the whole program shows: latency, memory, and answers to many clients under full vision load."""
    port = free_port()
    print("bench: tripointd on simulated cameras ...", file=sys.stderr, flush=True)
    with running_unit(programs / "tripointd", port) as unit:
        time.sleep(WARM_UP_S)
        p50_us, p99_us = struct.unpack(">II", input_registers(port, 738, 4))
        load = of_program(programs / "bench_modbus", "--connect", str(port), "--seconds", str(LOAD_S))
        memory = resident_mb(unit.pid)
    figures = [
        Figure("frame_to_register_p50_ms", p50_us / 1000, "ms", None, True),
        at_most("frame_to_register_p99_ms", p99_us / 1000, "ms", 2),
        at_most("resident_memory_mb", memory, "MB", 64),
    ]
    return [asdict(figure) for figure in figures] + load


def main() -> int:
    programs, output = Path(sys.argv[1]), Path(sys.argv[2])
    figures = of_program(programs / "bench_detect") + of_program(programs / "bench_static")
    figures += of_program(programs / "bench_rendered_centroid") + of_program(programs / "bench_exposure")
    figures += of_program(programs / "bench_clutter", "--row", "640_yuyv", "--scenes", "1000")
    figures += of_program(programs / "bench_clutter")[OF_FIRST_ROW:]  # the first has more scenes above
    figures += of_program(programs / "bench_clutter_poses")
    figures += of_program(programs / "bench_tags")
    figures += of_program(programs / "bench_modulation") + of_program(programs / "bench_identity")
    figures += of_program(programs / "bench_coverage") + of_program(programs / "bench_bump")
    figures += of_instructions(programs) + of_program(programs / "bench_mjpeg")
    figures += of_program(programs / "bench_modbus") + of_the_unit(programs)
    output.write_text(json.dumps(figures, indent=1) + "\n")
    print(table_of_sizes(figures), table(figures), sep="\n\n")
    return 0 if all(figure["reached"] for figure in figures) else 1


if __name__ == "__main__":
    sys.exit(main())
