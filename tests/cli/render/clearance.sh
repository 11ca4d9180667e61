# `--clearance`: a line between the nearest points of what the cell keeps apart, green where it is kept, red where not.
box='<link name="body"><visual><geometry><box size="1 1 1"/></geometry></visual></link>'
echo "<robot name=\"box\">$box</robot>" >box.urdf
cat >cell.toml <<'TOML'
format = 1
[[device]]
name = "a"
model = "box.urdf"
[[device]]
name = "b"
model = "box.urdf"
pose = { xyz = [2, 0, 0] }
[[clearance]]
between = ["a", "b"]
min_m = 0.5
TOML
sed 's/min_m = 0.5/min_m = 1.5/' cell.toml >near.toml
sed 's/xyz = \[2/xyz = [0.9/' cell.toml >touch.toml
sed '/clearance/,$d' cell.toml >none.toml
# The pixels that are green, and red, among all that the line and its label change.
cat >inks.py <<'PY'
import struct, sys, zlib
def rows(path):
    data, at, packed = open(path, "rb").read(), 8, b""
    while at < len(data):
        size, kind = struct.unpack(">I4s", data[at:at + 8])
        if kind == b"IHDR":
            width, height, depth, color = struct.unpack(">IIBB", data[at + 8:at + 18])
        if kind == b"IDAT":
            packed += data[at + 8:at + 8 + size]
        at += size + 12
    step = {2: 3, 6: 4}[color]
    raw, line, pixels = zlib.decompress(packed), bytearray(width * step), []
    for y in range(height):
        kind, new = raw[y * (width * step + 1)], bytearray(raw[y * (width * step + 1) + 1:(y + 1) * (width * step + 1)])
        for i in range(len(new)):
            left = new[i - step] if i >= step else 0
            up, corner = line[i], line[i - step] if i >= step else 0
            paeth = min((left, up, corner), key=lambda v: abs(left + up - corner - v))
            new[i] = (new[i] + [0, left, up, (left + up) // 2, paeth][kind]) & 255
        line = new
        pixels += [tuple(new[i:i + 3]) for i in range(0, len(new), step)]
    return pixels
plain, drawn = rows(sys.argv[1]), rows(sys.argv[2])
changed = [d for p, d in zip(plain, drawn) if p != d]
green = sum(g > 150 and r < 120 and b < 140 for r, g, b in changed)
red = sum(r > 200 and g < 130 and b < 120 for r, g, b in changed)
said = ["changed" if changed else "unchanged", "green" if green > 20 else "", "red" if red > 20 else ""]
print(*filter(None, said))
PY
draw() { rocinante render "$1" --size 320x240 --samples 1 --camera @1,-5,1/1,0,0 "${@:3}" -o "$2" --force; }
for cell in cell near touch none; do
  draw $cell.toml plain.png
  draw $cell.toml lined.png --clearance
  echo "$cell: $(python3 inks.py plain.png lined.png)"
done
draw cell.toml m.png --clearance --lengths m
draw cell.toml mm.png --clearance
cmp -s m.png mm.png || echo "lengths in metres are other pixels"
