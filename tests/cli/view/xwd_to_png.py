"""What xwd wrote of a window, as PNG: xwd_to_png.py DUMP PNG"""
import struct, sys, zlib
dump = open(sys.argv[1], "rb").read()
head = struct.unpack(">25I", dump[:100])
offset, width, height, order, depth_bits, stride, colors = head[0], head[4], head[5], head[7], head[11], head[12], head[19]
assert depth_bits == 32 and order == 0, "not 32 bits, least significant first"
rows = dump[offset + 12 * colors:]
raw = b"".join(b"\0" + b"".join(bytes((row[i + 2], row[i + 1], row[i], 255)) for i in range(0, 4 * width, 4))
               for row in (rows[y * stride:(y + 1) * stride] for y in range(height)))
def chunk(kind, data):
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
with open(sys.argv[2], "wb") as out:
    out.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 6, 0, 0, 0)) +
              chunk(b"IDAT", zlib.compress(raw)) + chunk(b"IEND", b""))
