# A report of CI in which a run differs: its frames and its run are accepted from a ZIP file, a folder and a list.
# Skipped without libzip: a folder is taken by the same code then.
grep -q "^  zip *on" <(rocinante --version --parts 2>/dev/null) || { echo "skipped: no libzip"; exit 77; }
export ROCINANTE_USER=ada XDG_CACHE_HOME=$PWD/cache
cp -r "$SRC/examples/demo/demo.cell.toml" "$SRC/examples/demo/arm" "$SRC/examples/demo"/*.urdf "$SRC/examples/demo"/*.obj \
  "$SRC/examples/demo"/*.mtl "$SRC/examples/demo/textures" "$SRC/examples/demo/session.mcap" .
cat >suite.toml <<'TOML'
format = 1
cell = "demo.cell.toml"
[[case]]
name = "sky"
size = [64, 48]
samples = 1
[[run]]
name = "lift"
mask = ["drawing/planner/*"]
TOML
listed() {
  python3 -c 'import json, sys
report = json.load(open(sys.argv[1]))
for one in report["frames"] + report["runs"]:
    print(one["name"], one.get("log_bytes") or one["pixels"], sep="\t")' "$1"
}
rocinante golden approve suite.toml --run lift -m first --log lift=session.mcap
rocinante log filter session.mcap --source gantry --source planner -o others.mcap >made.txt
rocinante log cut session.mcap --until 13s -o begin.mcap >made.txt
rocinante log merge begin.mcap others.mcap -o still.mcap >made.txt || true
rocinante golden run suite.toml --log lift=still.mcap --report report --summary page.md >said.txt || echo "exit $?"
ls report
grep '^Accept all' page.md
listed report/report.json >list.txt
mv still.mcap kept.mcap
python3 -m zipfile -c report.zip report
cp -r goldens before
accept() {
  rm -rf goldens
  cp -r before goldens
  rocinante golden approve suite.toml --from list.txt -m "the arm may rest" "$@" >said.txt 2>faults.txt || echo "exit $?"
  sed '/ beyond what was accepted/d' faults.txt
  sed '/^  widens/d' said.txt
}
echo "-- refused, as approve --run refuses it"
accept --artifact report.zip
echo "-- from the ZIP file, and from the folder"
accept --artifact report.zip --anyway
rocinante golden run suite.toml --log lift=kept.mcap | sed 's/: .*//' | sed -n 1,2p
accept --artifact report --anyway
echo "-- from the list, with the log"
accept --anyway --log lift=kept.mcap
echo "-- another log, another list, a report without the log"
accept --anyway --log lift=session.mcap
sed -i -E 's/^(lift\t).*/\10123456789abcdef0123456789abcdef/' list.txt
accept --artifact report --anyway
rm report/lift.run.mcap
accept --artifact report --anyway
cp session.mcap report/lift.run.mcap
accept --artifact report --anyway
