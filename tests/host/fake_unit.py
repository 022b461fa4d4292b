"""A Modbus TCP server for tests: answers from an image like a unit, or misbehaves as told."""

import socketserver
import struct
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from enum import Enum

from host.register_image import IMAGE_LENGTH, MIRROR_AT, Image

READS = (3, 4)
LATE_S = 0.5


class Manner(Enum):
    """How the server treats a request."""

    WELL = "answers"
    SILENT = "never answers"
    CLOSING = "closes the connection"
    REFUSING = "answers with exception 02"
    SHORT = "answers with one register too few"
    NOISE = "answers with bytes that are no Modbus"
    LATE = "answers the first request LATE_S too late, the others well"


class FakeUnit(socketserver.ThreadingTCPServer):
    """`image` is asked anew for every request, so that a test can let time pass."""

    allow_reuse_address = True
    daemon_threads = True

    def __init__(self, image: Callable[[], Image], manner: Manner, tables: tuple[int, ...]) -> None:
        super().__init__(("127.0.0.1", 0), _Connection)
        self.image = image
        self.manner = manner
        self.tables = tables
        self.written: list[tuple[int, int]] = []

    @property
    def device(self) -> str:
        """What --device takes."""
        return f"127.0.0.1:{self.server_address[1]}"


class _Connection(socketserver.StreamRequestHandler):
    def handle(self) -> None:
        while len(header := self.rfile.read(7)) == 7:
            transaction, _, length, unit = struct.unpack(">HHHB", header)
            pdu = self.rfile.read(length - 1)
            answer = _answer(self.server, pdu)  # type: ignore[arg-type]
            if answer is None:
                return
            if self.server.manner is Manner.LATE:  # type: ignore[attr-defined]
                self.server.manner = Manner.WELL  # type: ignore[attr-defined]
                time.sleep(LATE_S)
            if answer:
                self.wfile.write(struct.pack(">HHHB", transaction, 0, len(answer) + 1, unit) + answer)


def _answer(server: FakeUnit, pdu: bytes) -> bytes | None:
    """The PDU to send; empty for none; None to hang up."""
    code = pdu[0]
    refusal = bytes((code | 0x80, 2))
    special = {Manner.SILENT: b"", Manner.CLOSING: None, Manner.REFUSING: refusal, Manner.NOISE: b"\x03\xff\x00"}
    if server.manner in special:
        return special[server.manner]
    if code == 0x2B:
        return b"\x2b\x0e\x01\x81\x00\x00\x01\x00\x08Tripoint"
    address, value = struct.unpack(">HH", pdu[1:5])
    if code == 6:
        server.written.append((address, value))
        return pdu
    words = _words_at(server.image(), address, value)
    if code not in READS or words is None or code not in server.tables:
        return refusal
    words = words[:-1] if server.manner is Manner.SHORT else words
    return struct.pack(f">BB{len(words)}H", code, 2 * len(words), *words)


def _words_at(image: Image, address: int, count: int) -> list[int] | None:
    if address + count <= IMAGE_LENGTH:
        return image.words[address : address + count]
    if address >= MIRROR_AT and address + count <= MIRROR_AT + IMAGE_LENGTH:
        return image.mirrored()[address - MIRROR_AT : address - MIRROR_AT + count]
    return None


@contextmanager
def fake_unit(
    image: Callable[[], Image], manner: Manner = Manner.WELL, tables: tuple[int, ...] = READS
) -> Iterator[FakeUnit]:
    """A running server on a free port."""
    with FakeUnit(image, manner, tables) as server:
        thread = threading.Thread(target=server.serve_forever, kwargs={"poll_interval": 0.01})
        thread.start()
        try:
            yield server
        finally:
            server.shutdown()
            thread.join()
