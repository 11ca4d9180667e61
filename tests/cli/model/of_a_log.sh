# A cell that includes another and changes materials comes along in a log, and is the same there.
cp -r "$SRC/examples/demo" demo && cd demo
sed 's/^format = 1$/format = 1\n[[material]]\ndevice = "tanks"\ntexture = "textures\/sign.png"/' demo.cell.toml >site.cell.toml
printf 'format = 1\ninclude = ["site.cell.toml"]\n' >main.cell.toml
rocinante log attach session.mcap --cell main.cell.toml -o ../alone.mcap >/dev/null
rocinante model info main.cell.toml --json >../outside.json
cd .. && mv demo gone
rocinante model info alone.mcap --json >inside.json
python3 - <<'PY'
import json
outside, inside = json.load(open('outside.json')), json.load(open('inside.json'))
print(inside['file'], inside['textures'], inside['faults'])
for key in outside:
    if key not in ('file', 'name', 'texture_files') and outside[key] != inside[key]:
        print(key, 'differs')
PY
rocinante model fk alone.mcap --device gantry --log alone.mcap --at 7.88 | tail -n 1
