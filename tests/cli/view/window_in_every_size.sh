# The window at eight sizes in both themes, with a log, at rest, listening, and with sixty devices of long names: the
# pictures that were looked at and accepted, by their pixels' hashes. Dear ImGui's panels differ from release to release,
# and renderers by rounding, so they are known by both. ROCINANTE_UPDATE=1 keeps this machine's: look at them (PICTURES).
# With any renderer each of their texts has a contrast of 4.5 or more, none is cut off at an edge, and no panel lies on
# an inset.
export ASAN_OPTIONS=detect_leaks=0
demo=$SRC/examples/demo
imgui=imgui$(rocinante --version --parts | sed -n 's/.* imgui \([0-9]*\.[0-9]*\).*/\1/p')
key=$imgui-$(rocinante render "$demo/demo.cell.toml" --size 32x24 --hash --json | sed -n 's/^ *"renderer": "\(.*\)",$/\1/p')
accepted=$SRC/tests/cli/view/window/$key.sizes
cat >make.py <<'PYTHON'
import pathlib
pathlib.Path("arm.urdf").write_text("""<robot name="arm"><link name="base"/>
<link name="hand"><visual><geometry><box size="0.4 0.4 0.8"/></geometry></visual></link>
<joint name="left_shoulder_pan_joint" type="revolute"><parent link="base"/><child link="hand"/>
<origin xyz="0 0 0.5"/><axis xyz="0 0 1"/><limit lower="-3" upper="3" effort="1" velocity="1"/></joint></robot>""")
cell = 'format = 1\n'
for i in range(60):
    cell += (f'[[device]]\nname = "packaging_line_{i // 10}_robot_cell_{i % 10}_manipulator"\nmodel = "arm.urdf"\n'
             f'pose = {{ xyz = [{i % 10 * 1.5}, {i // 10 * 1.5}, 0] }}\n')
cell += '[[camera]]\nname = "over"\neye = [4, -14, 13]\ntarget = [6, 3, 0]\n'
for camera, corner in ("map", "top-right"), ("over", "bottom-right"), ("fit", "top-right"):
    cell += f'[[inset]]\ncamera = "{camera}"\ncorner = "{corner}"\n'
pathlib.Path("many.cell.toml").write_text(cell)
sizes = "480 320", "640 400", "800 500", "1024 640", "1280 720", "1600 900", "1920 1080 2", "2560 1440 2"
begins = {"log": ["seek 7.88s", "select arm", "plot arm.joint1", "plot arm.joint2", "findings on"], "rest": [],
          "many": ["camera @20,-4,6/6,3,0", "select packaging_line_2_robot_cell_3_manipulator"], "live": []}
for name, begin in begins.items():
    lines = list(begin)
    for theme in "dark", "light":
        lines.append(f"theme {theme}")
        for size in sizes:
            lines += [f"window-size {size}", "frame 3", f"screenshot {name}-{theme}-{size.split()[0]}.png",
                      f"legibility {name}-{theme}-{size.split()[0]}.csv"]
    pathlib.Path(name + ".script").write_text("\n".join(lines + ["quit", ""]))
PYTHON
python3 make.py
cp "$demo/session.mcap" .
look() {
  with_display rocinante view "${@:2}" --fresh --samples 1 --profile reproducible --script "$1.script"
}
look log "$demo/demo.cell.toml" session.mcap
look rest "$demo/demo.cell.toml"
look many many.cell.toml
look live "$demo/demo.cell.toml" --live 'udp://239.255.19.97:29871?interface=lo' --keep 0
cat >read.py <<'PYTHON'
import csv, pathlib, sys
tables = {file.stem: list(csv.DictReader(file.open())) for file in sorted(pathlib.Path(".").glob("*-*-*.csv"))}
faults = [(name, *row.values()) for name, rows in tables.items() for row in rows if row["fault"] != "-"]
# A window that says nothing is not legible.
faults += [(name, "says too little") for name, rows in tables.items() if "-2560" in name and len(rows) < 20]
for fault in faults:
    print(*fault)
print(len(tables), "pictures,", len(faults), "of their texts cannot be read")
sys.exit(1 if faults else 0)
PYTHON
python3 read.py
cat >hash.py <<'PYTHON'
import hashlib, pathlib, struct, zlib
for file in sorted(pathlib.Path(".").glob("*-*-*.png")):
    png, at, pixels = file.read_bytes(), 8, b""
    while at < len(png):
        size, kind = struct.unpack(">I4s", png[at:at + 8])
        pixels += png[at + 8:at + 8 + size] if kind == b"IDAT" else b""
        at += size + 12
    print(hashlib.sha256(zlib.decompress(pixels)).hexdigest()[:16], file.stem)
PYTHON
python3 hash.py >sizes.txt
wc -l <sizes.txt
[ -z "${PICTURES:-}" ] || cp ./*-*-*.png "$PICTURES"
[ -z "${ROCINANTE_UPDATE:-}" ] || cp sizes.txt "$accepted"
[ -e "$accepted" ] || { echo "skipped: no pictures of $key are accepted"; exit 77; }
diff "$accepted" sizes.txt && echo "as accepted"
