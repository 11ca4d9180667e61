# A golden that is not what was accepted judges nothing, whatever became of it: cut off anywhere, of another depth or
# kind, of another size, a folder, a pointer of Git LFS. What only packs the same pixels otherwise is the golden still.
export ROCINANTE_USER=ada
box() {
  cat >box.urdf <<URDF
<robot name="box"><link name="body"><visual><geometry><box size="1 1 $1"/></geometry>
<material name="red"><color rgba="0.8 0.3 0.1 1"/></material></visual></link></robot>
URDF
}
box 1
printf 'format = 1\ncell = "box.urdf"\n[[case]]\nname = "a"\nsize = [64, 48]\nsamples = 1\ntolerance = { tile_mean = 255, tile_over = 256 }\n' >suite.toml
rocinante golden approve suite.toml -m first >/dev/null
golden=$(ls goldens/a.*.png)
cp "$golden" accepted.png
cat >spoil.py <<'PYTHON'
import struct, sys, zlib
def chunks(data):
    at, found = 8, {}
    while at < len(data):
        size, kind = struct.unpack(">I4s", data[at:at + 8])
        found[kind] = found.get(kind, b"") + data[at + 8:at + 8 + size]
        at += 12 + size
    return found
def pixels(data):
    found = chunks(data)
    width, height = struct.unpack(">II", found[b"IHDR"][:8])
    packed, rows, before = zlib.decompress(found[b"IDAT"]), [], bytes(width * 4)
    for y in range(height):
        kind, row = packed[y * (width * 4 + 1)], bytearray(packed[y * (width * 4 + 1) + 1:(y + 1) * (width * 4 + 1)])
        for i in range(len(row)):
            left = row[i - 4] if i >= 4 else 0
            up, corner = before[i], before[i - 4] if i >= 4 else 0
            p = left + up - corner
            nearest = min((abs(p - left), 0, left), (abs(p - up), 1, up), (abs(p - corner), 2, corner))[2]
            row[i] = (row[i] + [0, left, up, (left + up) // 2, nearest][kind]) & 255
        rows.append([tuple(row[i:i + 4]) for i in range(0, len(row), 4)])
        before = bytes(row)
    return rows
def png(rows, depth, kind, row_bytes, more=()):
    def chunk(name, content):
        return struct.pack(">I", len(content)) + name + content + struct.pack(">I", zlib.crc32(name + content))
    head = struct.pack(">IIBBBBB", len(rows[0]), len(rows), depth, kind, 0, 0, 0)
    body = zlib.compress(b"".join(b"\0" + row_bytes(row) for row in rows))
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + b"".join(chunk(*one) for one in more) + chunk(b"IDAT", body) + chunk(b"IEND", b"")
rows, how = pixels(open("accepted.png", "rb").read()), sys.argv[1]
colors = sorted({pixel for row in rows for pixel in row})[:256]
made = {
    "packed": lambda: png(rows, 8, 2, lambda row: bytes(v for pixel in row for v in pixel[:3])),
    "wide": lambda: png(rows, 16, 6, lambda row: bytes(v for pixel in row for c in pixel for v in (c, c ^ 1))),
    "grey": lambda: png(rows, 8, 0, lambda row: bytes(pixel[1] for pixel in row)),
    "clear": lambda: png(rows, 8, 6, lambda row: bytes(v for r, g, b, a in row for v in (r, g, b, 254))),
    "palette": lambda: png(rows, 8, 3, lambda row: bytes(colors.index(p) if p in colors else 0 for p in row),
                           [(b"PLTE", bytes(v for color in colors[:8] for v in color[:3]) * 32)]),
    "cropped": lambda: png(rows[:-1], 8, 6, lambda row: bytes(v for pixel in row for v in pixel)),
}
open(sys.argv[2], "wb").write(made[how]())
PYTHON
run() { rocinante golden run suite.toml | sed "/^why/d; /^    /d; s#$golden#GOLDEN#; s/mean [0-9.]* /mean M /; s/and [0-9]* <=/and N <=/" | sed -n 1p && echo "exit 0" || echo "exit $?"; }
box 1.2
run
for how in packed wide; do
  echo "$how:"
  python3 spoil.py $how "$golden"
  run
done
for how in grey clear palette cropped; do
  echo "$how:"
  python3 spoil.py $how "$golden"
  run
done
echo "a pointer:"
printf 'version https://git-lfs.github.com/spec/v1\noid sha256:00\nsize 3\n' >"$golden"
run
echo "empty:"
: >"$golden"
run
echo "a folder:"
rm "$golden" && mkdir "$golden"
run
rmdir "$golden"
echo "gone:"
run
# Cut off at each fiftieth, that is said without drawing anything.
size=$(stat -c %s accepted.png)
told=0
for i in $(seq 0 49); do
  head -c $((size * i / 50)) accepted.png >"$golden"
  rocinante golden list suite.toml --verify >listed.txt && echo "believed at $i"
  grep -q 'cannot be read' listed.txt && told=$((told + 1))
done
echo "$told of 50 told"
cp accepted.png "$golden"
rocinante golden list suite.toml --verify | tail -1
