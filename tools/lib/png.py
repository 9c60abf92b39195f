"""PNG files of 8 bits a channel."""

import struct
import zlib

RGB, GREY_ALPHA, RGBA = 2, 4, 6


def png_file(size, color_type, data):
    """A PNG of (width, height) pixels whose compressed rows are data, taken as it is."""

    def chunk(kind, content):
        body = kind + content
        return struct.pack(">I", len(content)) + body + struct.pack(">I", zlib.crc32(body))

    header = chunk(b"IHDR", struct.pack(">IIBBBBB", *size, 8, color_type, 0, 0, 0))
    return b"\x89PNG\r\n\x1a\n" + header + chunk(b"IDAT", data) + chunk(b"IEND", b"")
