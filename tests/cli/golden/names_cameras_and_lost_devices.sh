# The first line of a failing frame names its cause where that is a camera, of the cell or of the suite, or a device that
# the frame does not show.
export ROCINANTE_USER=ada XDG_CACHE_HOME=$PWD/cache
cp -r "$SRC/examples/demo/demo.cell.toml" "$SRC/examples/demo/arm" "$SRC/examples/demo"/*.urdf "$SRC/examples/demo"/*.obj \
  "$SRC/examples/demo"/*.mtl "$SRC/examples/demo/textures" "$SRC/examples/demo/session.mcap" .
cat >s.toml <<'TOML'
format = 1
cell = "demo.cell.toml"
log = "session.mcap"
[defaults]
size = [160, 120]
[[case]]
name = "lift"
at = "6s"
TOML
rocinante golden approve s.toml -m first
cp demo.cell.toml kept.cell.toml
cp s.toml kept.toml
run() {
  echo "-- $1"
  { rocinante golden run s.toml 2>said.txt || true; } | grep -E '^(in|different|same)' | sed 's/[0-9]* differing/N differing/'
  cp kept.cell.toml demo.cell.toml
  cp kept.toml s.toml
}
run "as accepted"
sed -i 's/^eye = \[3.9,/eye = [4.2,/' demo.cell.toml
run "the camera has moved"
sed -i 's/^at = "6s"/at = "6s"\ncamera = "arm"/' s.toml
run "the suite names another camera"
sed -i 's/^at = "6s"/at = "6s"\nhide = ["canister"]/' s.toml
run "the suite hides a device"
python3 - <<'PYTHON'
import re
tables = re.split(r"(?m)^(?=\[\[)", open("demo.cell.toml").read())
open("demo.cell.toml", "w").write("".join(t for t in tables if not (t.startswith("[[device]]") and 'name = "arm"' in t)))
PYTHON
run "the cell has lost a device"
rocinante log filter session.mcap --source gantry --source planner -o others.mcap >made.txt
sed -i 's/session.mcap/others.mcap/' s.toml
run "the log has lost a device"
