# Names that are longer than a panel is wide: no edge cuts them, and where their middle is left out the mouse shows the
# whole name. `legibility` tells what the window says.
export ASAN_OPTIONS=detect_leaks=0
cat >arm.urdf <<'URDF'
<robot name="arm"><link name="base"><visual><geometry><box size="1 1 1"/></geometry></visual></link></robot>
URDF
cat >cell.toml <<'CELL'
format = 1
[[layer]]
name = "what the supplier of the packaging line delivered in the second lot"
[[device]]
name = "packaging_line_in_hall_7_robot_cell_12_upper_manipulator"
model = "arm.urdf"
layer = "what the supplier of the packaging line delivered in the second lot"
[[camera]]
name = "from_above_the_packaging_line_in_hall_7_towards_the_gate"
eye = [4, -4, 3]
target = [0, 0, 0]
[[inset]]
camera = "from_above_the_packaging_line_in_hall_7_towards_the_gate"
corner = "top-right"
CELL
echo "legibility early.csv" >early.txt
with_display rocinante view cell.toml --fresh --script early.txt 2>&1 || true
cat >script.txt <<'SCRIPT'
window-size 1000 700
camera from_above_the_packaging_line_in_hall_7_towards_the_gate
select packaging_line_in_hall_7_robot_cell_12_upper_manipulator
frame 3
legibility rest.csv
mouse 60 48
frame 3
legibility camera.csv
mouse 60 129
frame 3
legibility layer.csv
mouse 60 75
button left down
frame 1
button left up
frame 3
mouse 100 102
frame 3
legibility inset.csv
quit
SCRIPT
with_display rocinante view cell.toml --fresh --samples 1 --profile reproducible --script script.txt
cat >read.py <<'PYTHON'
import csv
tables = {name: list(csv.DictReader(open(name + ".csv"))) for name in ("rest", "camera", "layer", "inset")}
known = {row["text"] for row in tables["rest"]}
for name, rows in tables.items():
    for row in rows:
        if row["fault"] != "-":
            print(*row.values())
        elif row["text"] not in known and "…" not in row["text"]:
            print(f"{name}: {row['text']}")
PYTHON
python3 read.py
