"""Picture files for tests, written without a library."""

import struct
import zlib


def png(width_px: int, height_px: int, rgb: bytes, *, grey: bool = False) -> bytes:
    """A PNG file of rows of RGB or grey."""

    def chunk(kind: bytes, data: bytes) -> bytes:
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    row = width_px * (1 if grey else 3)
    rows = b"".join(b"\0" + rgb[y * row : (y + 1) * row] for y in range(height_px))
    header = struct.pack(">IIBBBBB", width_px, height_px, 8, 0 if grey else 2, 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b"")
