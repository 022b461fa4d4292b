"""Which rooms may see which header from outside the repository. What is not named here, nobody may include.

Only the part of the standard library that touches the world is named: the rest is free. So a stage of the line, which
stands in no row of it, does no I/O, starts no thread and draws no random number.
"""

from __future__ import annotations

# A name that ends in "/" stands for all below it.
ROOMS: dict[str, set[str]] = {
    # libraries
    "Eigen/": {
        "values",
        "geometry",
        "line/detect",
        "line/match",
        "line/pose",
        "line/monitor",
        "tags",
        "calibration",
        "serve",
        "bench",
    },
    "tl/expected.hpp": {"values"},
    "fmt/": {
        *("app", "calibration", "capture", "config", "devices", "document", "explain", "net", "recording", "serve"),
        "sim",
    },
    "spdlog/": {"app"},
    "nlohmann/json.hpp": {"app"},
    "CLI/CLI.hpp": {"app", "sim"},
    "boost/asio/": {"net"},
    "toml++/": {"document"},
    "openssl/evp.h": {"document"},
    "jpeglib.h": {"capture", "sim"},
    "jerror.h": {"capture"},
    "png.h": {"capture", "explain"},
    "apriltag/": {"tags", "bench"},  # bench: what following tags is measured against
    "opencv2/": {"bench"},  # what the detector is measured against
    "zlib.h": {"fuzz"},
    # devices and descriptors
    "linux/videodev2.h": {"devices"},
    "sys/ioctl.h": {"devices"},
    "sys/mman.h": {"devices"},
    "poll.h": {"devices"},
    "fcntl.h": {"devices", "document"},
    "unistd.h": {"devices", "document", "bench"},
    "sys/stat.h": {"document"},
    # clock, threads, signals
    "sys/timex.h": {"devices"},
    "sched.h": {"devices"},
    "pthread.h": {"app", "devices"},
    # network; the server's sockets are Asio's, those of bench are its clients'
    "sys/socket.h": {"bench"},
    "sys/epoll.h": {"bench"},
    "netinet/": {"bench"},
    "arpa/inet.h": {"config", "bench"},  # config: only inet_pton, the check of an address
    # the standard library where it touches the world
    "fstream": {"capture", "devices", "sim"},
    "filesystem": {"app", "calibration", "capture", "config", "devices", "document", "recording", "sim"},
    "iostream": {"app"},
    "cstdio": {"values", "capture", "sim", "app", "bench"},  # values: the last words of a failed assertion
    "csetjmp": {"capture"},  # how libjpeg and libpng report an error
    "csignal": {"app"},
    "ctime": {"devices", "net", "bench"},
    "thread": {"net", "sim", "app", "bench"},
    "future": set(),
    "random": {"sim", "bench"},
}


def complaint(room: str, header: str) -> str | None:
    """Why the room may not include <header>; None when it may."""
    for name, rooms in ROOMS.items():
        if header == name or (name.endswith("/") and header.startswith(name)):
            return None if room in rooms else f"the room '{room}' may not include <{header}>: only {_listed(rooms)} may"
    if "/" in header or "." in header:
        return f"nobody may include <{header}>: a room that needs it is named in tests/tidy/outside_headers.py"
    return None


def _listed(rooms: set[str]) -> str:
    return ", ".join(sorted(rooms)) or "nobody"
