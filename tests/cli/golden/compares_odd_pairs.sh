# Pictures of other programs: one pixel, another gamma, floating point, pipes and devices.
python3 - <<'PY'
import struct, zlib
def chunk(kind, content):
    return struct.pack(">I", len(content)) + kind + content + struct.pack(">I", zlib.crc32(kind + content))
def png(name, width, height, kind, rows, more=b""):
    open(name, "wb").write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, kind, 0, 0, 0))
                           + more + chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))
png("one.png", 1, 1, 6, b"\0\x10\x20\x30\xff")
png("other.png", 1, 1, 6, b"\0\x11\x20\x30\xff")
png("rgb.png", 16, 16, 2, (b"\0" + b"\x50\x60\x70" * 16) * 16)
png("linear.png", 16, 16, 2, (b"\0" + b"\x50\x60\x70" * 16) * 16, chunk(b"gAMA", struct.pack(">I", 100000)))
png("clear.png", 16, 16, 2, (b"\0" + b"\x50\x60\x70" * 16) * 16, chunk(b"tRNS", struct.pack(">HHH", 0x50, 0x60, 0x70)))
turn = b"MM\0*" + struct.pack(">IHHHIHHI", 8, 1, 0x112, 3, 1, 6, 0, 0)
png("turned.png", 16, 16, 2, (b"\0" + b"\x50\x60\x70" * 16) * 16, chunk(b"eXIf", turn))
def exr(name, value):
    def attribute(name, kind, content):
        return name + b"\0" + kind + b"\0" + struct.pack("<I", len(content)) + content
    channels = b"".join(name + b"\0" + struct.pack("<IBBBBII", 2, 0, 0, 0, 0, 1, 1) for name in (b"B", b"G", b"R"))
    box = struct.pack("<iiii", 0, 0, 15, 15)
    head = struct.pack("<II", 20000630, 2) + attribute(b"channels", b"chlist", channels + b"\0")
    head += attribute(b"compression", b"compression", b"\0") + attribute(b"dataWindow", b"box2i", box)
    head += attribute(b"displayWindow", b"box2i", box) + attribute(b"lineOrder", b"lineOrder", b"\0")
    head += attribute(b"pixelAspectRatio", b"float", struct.pack("<f", 1))
    head += attribute(b"screenWindowCenter", b"v2f", struct.pack("<ff", 0, 0))
    head += attribute(b"screenWindowWidth", b"float", struct.pack("<f", 1)) + b"\0"
    line = 8 + 16 * 12
    offsets = b"".join(struct.pack("<Q", len(head) + 8 * 16 + y * line) for y in range(16))
    lines = b"".join(struct.pack("<iI", y, 16 * 12) + struct.pack("<48f", *[value(c % 16, y) for c in range(48)]) for y in range(16))
    open(name, "wb").write(head + offsets + lines)
exr("even.exr", lambda x, y: 0.25)
exr("near.exr", lambda x, y: 0.25 + 1e-6 * (x == 3))
exr("nan.exr", lambda x, y: float("nan") if (x, y) == (5, 6) else 0.25)
exr("infinite.exr", lambda x, y: float("inf") if (x, y) == (5, 6) else 0.25)
PY
judge() { timeout 20 rocinante golden compare "$@" 2>&1 | sed '/^    |/d' && echo "exit 0" || echo "exit $?"; }
judge one.png one.png
judge other.png one.png
judge other.png one.png --tier cpu --quiet
for other in linear clear turned; do judge $other.png rgb.png --quiet; done
rocinante golden compare even.exr even.exr --quiet >said 2>&1 || true
if grep -q 'without the OpenImageIO module' said; then
  echo "skipped: no OpenImageIO module"; exit 77
fi
judge even.exr even.exr --quiet
judge near.exr even.exr --quiet
judge near.exr even.exr --tier cpu --quiet
judge even.exr rgb.png --tier loose --quiet
judge nan.exr even.exr --tier loose
judge even.exr infinite.exr
judge nan.exr nan.exr --json | grep -E '"(verdict|rule)"|exit'
judge /dev/null rgb.png
judge rgb.png /dev/zero
judge - rgb.png --quiet <rgb.png
judge - rgb.png --quiet < <(cat rgb.png)
judge rgb.png <(cat rgb.png) --quiet
judge - even.exr < <(cat even.exr)
judge - - </dev/null
judge - rgb.png </dev/null
