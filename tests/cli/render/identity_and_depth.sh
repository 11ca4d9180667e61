# Whose the pixels are and how far, with legends beside them.
cat > box.urdf <<'URDF'
<robot name="box"><link name="body"><visual><geometry><box size="1 1 1"/></geometry></visual></link></robot>
URDF
cat > cell.toml <<'TOML'
format = 1
[[device]]
model = "box.urdf"
[[camera]]
name = "front"
eye = [-4.5, 0, 0]
target = [0, 0, 0]
ortho_height_m = 2
TOML
rocinante-render cell.toml --size 64x48 --identity ids.png --depth depth.png
cat ids.json depth.json
python3 - <<'PY'
import zlib, struct
data = open('depth.png', 'rb').read()
print(struct.unpack('>IIBB', data[16:26]))
body, at = b'', 8
while at < len(data):
    size, kind = struct.unpack('>I4s', data[at:at + 8])
    if kind == b'IDAT': body += data[at + 8:at + 8 + size]
    at += size + 12
raw = zlib.decompress(body)
rows, before = [], bytes(128)
for y in range(48):
    line = raw[y * 129:y * 129 + 129]
    row = bytearray(line[1:])
    for i in range(128):
        a = row[i - 2] if i > 1 else 0
        b, c = before[i], (before[i - 2] if i > 1 else 0)
        p = min((abs(b - c), 0, a), (abs(a - c), 1, b), (abs(a + b - 2 * c), 2, c))[2]
        row[i] = (row[i] + (0, a, b, (a + b) // 2, p)[line[0]]) & 255
    before = bytes(row)
    rows.append(struct.unpack('>64H', before))
print(rows[24][32], rows[24][0], sum(1 for row in rows for one in row if one))
PY
try() { rocinante-render cell.toml --size 64x48 "$@" 2>&1 && echo "exit 0" || echo "exit $?"; }
try --identity ids.png
try --identity same.png --depth same.png
try --depth depth.tif
ls
