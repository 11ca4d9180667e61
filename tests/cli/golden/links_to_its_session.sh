# With --page, what fails opens in a page of its session, at its moment: files, links, and what is gone once all is fine.
# The viewer is a stand-in: packing does not look into it.
export ROCINANTE_USER=ada XDG_CACHE_HOME=$PWD/cache
cp "$SRC"/examples/demo/*.* . && cp -r "$SRC/examples/demo/arm" "$SRC/examples/demo/textures" .
mv demo.cell.toml cell.toml && rm demo.suite.toml
mkdir viewer && echo 'var rocinanteViewer;' >viewer/rocinante-viewer.js && echo wasm >viewer/rocinante-viewer.wasm
cat >suite.toml <<'TOML'
format = 1
cell = "cell.toml"
log = "session.mcap"
[[case]]
name = "reach"
at = "2.5s"
camera = "overview"
size = [48, 36]
samples = 1
[[run]]
name = "lift"
TOML
run() { rocinante golden run suite.toml --report report --viewer viewer --page "$@" >said.txt || echo "exit $?"; }
links() {
  python3 - <<'PYTHON'
import json
report = json.load(open("report/report.json"))
print([frame.get("page") for frame in report["frames"]], [run.get("page") for run in report.get("runs", [])])
PYTHON
  ls report | grep html
}
echo "-- nothing was accepted"
run
links
rocinante page --extract report/session.html -o log.mcap | sed 's/: .*//'
cmp log.mcap session.mcap
grep -o '"page":"[^"]*"' report/index.html
echo "-- all is fine: no page, and the old one is gone"
rocinante golden approve suite.toml -m first >/dev/null
rocinante golden approve suite.toml --run lift -m first --log lift=session.mcap >/dev/null
run
links
echo "-- another run"
rocinante log filter session.mcap --source gantry --source planner -o others.mcap >/dev/null
rocinante log cut session.mcap --until 13s -o begin.mcap >/dev/null
rocinante log merge begin.mcap others.mcap -o still.mcap >/dev/null || true
run --log lift=still.mcap
links
echo "-- without a viewer, without a report"
rocinante golden run suite.toml --log lift=still.mcap --report report --page --viewer nowhere 2>&1 >/dev/null || echo "exit $?"
rocinante golden run suite.toml --page || echo "exit $?"
