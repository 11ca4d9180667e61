# A session is judged as motion against accepted ones: verdicts, words and exit codes, and every report.
export ROCINANTE_USER=ada XDG_CACHE_HOME=$PWD/cache
cp -r "$SRC/examples/demo/demo.cell.toml" "$SRC/examples/demo/arm" "$SRC/examples/demo"/*.urdf "$SRC/examples/demo"/*.obj \
  "$SRC/examples/demo"/*.mtl "$SRC/examples/demo/textures" "$SRC/examples/demo/session.mcap" .
cat >runs.toml <<'TOML'
format = 1
cell = "demo.cell.toml"
[[run]]
name = "lift"
align = "events"
limits = { joint_deg = 0.1, "gantry" = { position_mm = 2 } }
mask = ["drawing/planner/*"]
TOML
clean() { sed -E 's/lift\.[0-9a-f]{12}\.mcap/lift.HASH.mcap/g; s/"judge_ms": [0-9.e+-]+/"judge_ms": 0/; s/time="[0-9.]+"/time="0"/'; }
echo "-- nothing was accepted"
rocinante golden run runs.toml --log lift=session.mcap || echo "exit $?"
rocinante golden run runs.toml || echo "exit $?"
rocinante golden run runs.toml --log lower=session.mcap || echo "exit $?"
rocinante golden approve runs.toml --run lift -m first || echo "exit $?"
rocinante golden approve runs.toml --run lower -m first --log session.mcap || echo "exit $?"
echo "-- accepted"
rocinante golden approve runs.toml --run lift -m "the first" --log lift=session.mcap
rocinante golden approve runs.toml --run lift -m "the first" --log lift=session.mcap
rocinante golden list runs.toml --verify | sed -E 's/[0-9]{4}-[0-9-]+T[0-9:]+Z/NOW                 /' | clean
rocinante golden run runs.toml --log lift=session.mcap
echo "-- the arm stays where it is from 13 s on"
rocinante log filter session.mcap --source gantry --source planner -o others.mcap >made.txt
rocinante log cut session.mcap --until 13s -o begin.mcap >made.txt
rocinante log merge begin.mcap others.mcap -o still.mcap >made.txt || true
rocinante golden run runs.toml --log lift=still.mcap --junit junit.xml --sarif sarif.json --summary summary.md --json out.json \
  --report report >said.txt || echo "exit $?"
grep -c 'frozen at' said.txt
grep -E '^(different|run)|^1 run' said.txt | cut -c1-60
grep -c '<failure' junit.xml
python3 - <<'PYTHON'
import json
run = json.load(open("out.json"))["runs"][0]
print(run["name"], run["verdict"], run["align"], run["values"] > 20000, "step_ns" in run)
first = next(f for f in run["findings"] if f["item"] == "arm/joint2")
print(first["kind"], first["unit"], 12.9 < first["first_accepted_ns"] / 1e9 < 13.5, len(first["curve"]["seconds"]) > 100)
sarif = json.load(open("sarif.json"))["runs"][0]["results"][0]
print(sarif["ruleId"], sarif["locations"][0]["physicalLocation"]["region"]["startLine"])
PYTHON
head -3 summary.md | cut -c1-80
grep -c '"runs": \[' report/report.json
ls report
python3 - <<'PYTHON'
import json
run = json.load(open("out.json"))["runs"][0]
for picture in run["pictures"]:
    print(picture["file"], picture["device"], picture["run_ns"] // 10**8, picture["accepted_ns"] // 10**8)
page = open("report/index.html").read()
print(page.count('"file":"lift.run-'), "in the page")
PYTHON
rocinante golden run runs.toml --log lift=still.mcap --github | grep -c '^::error file=runs.toml,line=3' || echo "exit $?"
rocinante golden report report --json merged.json | tail -1 || echo "exit $?"
python3 -c 'import json; print(json.load(open("merged.json"))["runs"] == json.load(open("out.json"))["runs"])'
echo "-- now it is meant so: both are accepted, then only the new one"
rocinante golden approve runs.toml --run lift -m "the arm may rest" --log lift=still.mcap >said.txt || echo "exit $?"
rocinante golden approve runs.toml --run lift -m "the arm may rest" --log lift=still.mcap --anyway | tail -1
rocinante golden run runs.toml --log lift=still.mcap | cut -c1-60
rocinante golden approve runs.toml --run lift -m "it must" --log lift=still.mcap --replace
ls goldens | clean
rocinante golden run runs.toml --log lift=session.mcap >said.txt || echo "exit $?"
echo "-- what cannot be judged is not the same"
head -c 150000 session.mcap >cut.mcap
rocinante golden run runs.toml --log lift=cut.mcap | cut -c1-80 || true
rocinante golden run runs.toml --log lift=cut.mcap >said.txt || echo "exit $?"
rocinante golden approve runs.toml --run lift -m "cut" --log lift=cut.mcap || echo "exit $?"
rocinante log filter session.mcap --source arm -o arm.mcap >made.txt
rocinante golden run runs.toml --log lift=arm.mcap || echo "exit $?"
printf x >>goldens/lift.*.mcap
{ rocinante golden run runs.toml --log lift=still.mcap || echo "exit $?"; } | clean
{ rocinante golden list runs.toml --verify || echo "exit $?"; } | tail -4 | clean
echo "-- with a store"
sed -i 's/^cell/store = "store"\ncell/' runs.toml
rm -r goldens
rocinante golden approve runs.toml --run lift -m first --log lift=session.mcap
ls goldens store | sed -E 's/[0-9a-f]{64}/SESSION/'
rocinante golden run runs.toml --log lift=session.mcap
echo "-- suites that cannot be read"
refused() { sed "s/^align.*/$1/" runs.toml >bad.toml; rocinante golden list bad.toml || echo "exit $?"; }
refused 'align = "time"'
refused 'warp_ms = 100'
refused 'limits = { joint_deg = 0.01 }\n[x-rest]'
refused 'limits = { elbow = 3 }\n[x-rest]'
refused 'limits = { "arm\/joint1" = { deg = 3 } }\n[x-rest]'
refused 'align = "warp"\nwarp_ms = 5000'
refused 'mask = "arm"\n[x-rest]'
refused 'mask = [{ item = "arm", from = "2s", until = "1s" }]\n[x-rest]'
{ cat runs.toml; printf '[[run]]\nname = "lift"\n'; } >bad.toml
rocinante golden list bad.toml || echo "exit $?"
