# Pictures of every depth and kind, and files that are none: shape and finiteness first, never a yes.
python3 - <<'PY'
import struct, zlib
def chunk(kind, content):
    return struct.pack(">I", len(content)) + kind + content + struct.pack(">I", zlib.crc32(kind + content))
def png(name, width, height, depth, kind, rows, more=b""):
    open(name, "wb").write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, depth, kind, 0, 0, 0))
                           + more + chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))
png("rgba.png", 16, 16, 8, 6, (b"\0" + b"\x50\x50\x50\xff" * 16) * 16)
png("rgb.png", 16, 16, 8, 2, (b"\0" + b"\x50\x50\x50" * 16) * 16)
png("grey.png", 16, 16, 8, 0, (b"\0" + b"\x50" * 16) * 16)
png("palette.png", 16, 16, 8, 3, (b"\0" + b"\1" * 16) * 16, chunk(b"PLTE", b"\0\0\0\x50\x50\x50"))
png("clear.png", 16, 16, 8, 6, (b"\0" + b"\x50\x50\x50\xfe" * 16) * 16)
png("deep.png", 16, 16, 16, 0, (b"\0" + b"\x50\x50" * 16) * 16)
png("deeper.png", 16, 16, 16, 0, (b"\0" + b"\x50\x51" * 16) * 16)
png("cropped.png", 16, 15, 8, 6, (b"\0" + b"\x50\x50\x50\xff" * 16) * 15)
png("bomb.png", 60000, 60000, 8, 6, b"\0" * 100000)
whole = open("rgba.png", "rb").read()
open("cut.png", "wb").write(whole[:-20])
open("wrong_sum.png", "wb").write(whole[:45] + bytes([whole[45] ^ 1]) + whole[46:])
open("text.png", "w").write("this is a text and no picture at all")
def seen(name, more=b"", behind=b"", packed=zlib.compress(b"\0\1\2\3"), plte=b"", kind=0):
    open(name, "wb").write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", 3, 1, 8, kind, 0, 0, 0)) + more
                           + chunk(b"IDAT", packed) + chunk(b"IEND", b"") + behind)
seen("still.png")
seen("animation.png", more=chunk(b"acTL", struct.pack(">II", 2, 0)))
seen("two.png", behind=open("still.png", "rb").read())
seen("garbage.png", behind=b"behind the end")
seen("surplus.png", packed=zlib.compress(b"\0\1\2\3\0\1\2\3"))
seen("after_stream.png", packed=zlib.compress(b"\0\1\2\3") + b"more")
seen("no_such_colour.png", more=chunk(b"PLTE", b"abcdefghi"), kind=3)
PY
judge() { rocinante golden compare "$@" 2>&1 | sed '/^    |/d' && echo "exit 0" || echo "exit $?"; }
for other in rgb grey palette; do judge $other.png rgba.png --quiet; done
judge clear.png rgba.png
judge clear.png rgba.png --tier cpu --quiet
judge deep.png rgba.png --tier loose
judge deeper.png deep.png
judge deeper.png deep.png --tier cpu --quiet
judge cropped.png rgba.png --tier loose
for bad in bomb cut wrong_sum missing; do judge $bad.png rgba.png; judge rgba.png $bad.png --json | grep -E 'verdict|rule|exit'; done
# The same pixels for whoever only looks, but not all of what the file holds.
for odd in animation two garbage surplus after_stream no_such_colour; do judge $odd.png still.png --tier loose; judge $odd.png $odd.png; done
mkdir folder.png
judge folder.png rgba.png
judge text.png rgba.png | sed 's/: .* (/: ... (/'
judge rgba.png
judge rgba.png rgba.png --mask 1,2,3
judge clear.png rgba.png --mask 0,0,16x15 --mask 90,0,5x5 --quiet
judge clear.png rgba.png --mask 0,0,16x16
judge clear.png rgba.png --difference where.png --quiet
judge clear.png rgba.png --difference where.png --quiet
judge clear.png rgba.png --difference where.png --quiet --force
