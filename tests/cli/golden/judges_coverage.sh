# What is not judged is never the same: coverage of runs, names that match nothing, a changed model,
# and what may be accepted.
export ROCINANTE_USER=ada XDG_CACHE_HOME=$PWD/cache
cp -r "$SRC/examples/demo/demo.cell.toml" "$SRC/examples/demo/arm" "$SRC/examples/demo"/*.urdf "$SRC/examples/demo"/*.obj \
  "$SRC/examples/demo"/*.mtl "$SRC/examples/demo/textures" "$SRC/examples/demo/session.mcap" .
cat >runs.toml <<'TOML'
format = 1
cell = "demo.cell.toml"
[[run]]
name = "lift"
mask = ["drawing/planner/*"]
TOML
rocinante golden approve runs.toml --run lift -m first --log session.mcap
rocinante golden run runs.toml --log session.mcap --json out.json
python3 - <<'PYTHON'
import json
coverage = json.load(open("out.json"))["runs"][0]["coverage"]
print(len(coverage["judged"]), coverage["lost"], coverage["masked"], coverage["left_out"]["total"])
PYTHON
echo "-- the cell calls the arm otherwise"
sed -i.keep 's/^name = "arm"/name = "arn"/' demo.cell.toml
rocinante golden run runs.toml --log session.mcap || echo "exit $?"
mv demo.cell.toml.keep demo.cell.toml
echo "-- an axis is reversed"
sed -i.keep '44s/0 1 0/0 -1 0/' arm.urdf
rocinante golden run runs.toml --log session.mcap --json out.json >said.txt || echo "exit $?"
head -1 said.txt
grep -c 'lacks its mesh' said.txt || true
python3 -c 'import json; print([f["kind"] for f in json.load(open("out.json"))["runs"][0]["findings"]])'
mv arm.urdf.keep arm.urdf
echo "-- masks"
masked() { sed "s|^mask.*|mask = [$1]|" runs.toml >masked.toml; rocinante golden run masked.toml --log session.mcap || echo "exit $?"; }
masked '"*"'
masked '"gantri"'
masked '"gantry", { item = "arm", from = "2s", until = "3s" }'
echo "-- a log that should not be accepted"
rocinante log filter session.mcap --source planner -o planner.mcap >made.txt
rocinante golden approve runs.toml --run lift -m x --log planner.mcap || echo "exit $?"
printf 't,joint1,joint2\n' >degrees.csv
for i in $(seq 0 99); do printf '0.%02d,%d,%d\n' "$i" "$i" "$((90 - i))"; done >>degrees.csv
rocinante log import degrees.csv --device arm -o degrees.mcap >made.txt
sed 's/^mask.*/align = "origin"/' runs.toml >origin.toml
rocinante golden approve origin.toml --run lift -m x --log degrees.mcap || echo "exit $?"
rocinante golden approve origin.toml --run lift -m "as it is" --log degrees.mcap --anyway >said.txt 2>&1 || echo "exit $?"
tail -1 said.txt
grep 'has the same goldens' said.txt
