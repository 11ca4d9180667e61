"""Small pictures for the models, the same bytes on every machine."""
import struct
import zlib


def png(pixels):
    """An RGBA picture from rows of (r, g, b, a)."""
    rows = b"".join(b"\0" + bytes(c for pixel in row for c in pixel) for row in pixels)

    def chunk(kind, content):
        return (struct.pack(">I", len(content)) + kind + content
                + struct.pack(">I", zlib.crc32(kind + content)))

    head = struct.pack(">IIBBBBB", len(pixels[0]), len(pixels), 8, 6, 0, 0, 0)
    # Stored, not deflated: zlibs differ.
    block = b"\x78\x01\x01" + struct.pack("<HH", len(rows), len(rows) ^ 0xFFFF) + rows
    block += struct.pack(">I", zlib.adler32(rows))
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + chunk(b"IDAT", block)
            + chunk(b"IEND", b""))


RED, GREEN, BLUE, YELLOW = (220, 40, 40, 255), (40, 180, 60, 255), (50, 80, 220, 255), (240, 210, 40, 255)


def quarters(size=8):
    """Red top left, green top right, blue bottom left, yellow bottom right; a white corner."""
    half = size // 2
    rows = [[(RED if x < half else GREEN) if y < half else (BLUE if x < half else YELLOW)
             for x in range(size)] for y in range(size)]
    rows[0][0] = (255, 255, 255, 255)
    return png(rows)


def stripes(size=8):
    """Orange with alpha 0, 64, 160 and 255, from left to right."""
    return png([[(240, 130, 20, (0, 64, 160, 255)[x * 4 // size]) for x in range(size)]
                for _ in range(size)])
