# A picture is written as its ending says; what can hold the values holds them.
grep -q '^  openimageio *on ' <(rocinante --version --parts) || { echo "skipped: built without OpenImageIO"; exit 77; }
cat > box.urdf <<'URDF'
<robot name="box"><link name="body"><visual><geometry><box size="1 1 1"/></geometry>
<material name="m"><color rgba="0.8 0.3 0.1 1"/></material></visual></link></robot>
URDF
draw() { rocinante-render box.urdf --size 64x48 "$@"; }
draw -o box.png
for kind in tif bmp tga ppm exr; do
  draw -o box.$kind
  rocinante golden compare box.$kind box.png --tier exact >verdict 2>&1 || true
  echo "$kind: $(head -n 1 verdict)"
done
# What loses is read back as a picture of the same size; how much it loses is its library's matter.
for kind in jpg webp; do
  draw -o box.$kind
  rocinante golden compare box.$kind box.png --tier exact >verdict 2>&1 || true
  echo "$kind: $(sed -n '1s/:.*//p' verdict)"
done
echo "== frames and the sheet"
draw --frames frames --frame-type webp --sheet sheet.jpg
ls frames sheet.jpg
echo "== identity and depth as numbers"
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
rocinante-render cell.toml --size 64x48 --identity ids.exr --depth depth.exr
cat depth.json
python3 - ids.exr depth.exr <<'PY'
# OpenEXR file layout: attributes of the header.
import json, struct, sys
for name in sys.argv[1:]:
    data = open(name, 'rb').read()
    at, texts = 8, {}
    while data[at]:
        key, at = data[at:data.index(0, at)].decode(), data.index(0, at) + 1
        kind, at = data[at:data.index(0, at)].decode(), data.index(0, at) + 1
        size, = struct.unpack('<i', data[at:at + 4])
        value, at = data[at + 4:at + 4 + size], at + 4 + size
        if key == 'channels':
            end = value.index(0)
            print(name, value[:end].decode(), ('uint', 'half', 'float')[struct.unpack('<i', value[end + 1:end + 5])[0]])
        if key == 'rocinante':
            legend = json.loads(value)
            print(name, legend.get('names', legend.get('nearest_m')))
            assert legend == json.load(open(name[:-4] + '.json'))
PY
echo "== refused"
try() { draw "$@" 2>&1 && echo "exit 0" || echo "exit $?"; }
try -o box.xyz
try --frames other --frame-type xyz
try --depth depth.tif
