# Where CI looks: the frame that failed at its case's line, by SARIF, by JUnit and by annotations.
export ROCINANTE_USER=ada
cat >plate.urdf <<'URDF'
<robot name="plate"><link name="body"><visual><geometry><box size="1 1 0.1"/></geometry></visual></link></robot>
URDF
cat >"a suite.toml" <<'TOML'
format = 1
cell = "plate.urdf"
[[case]]
name = "at-rest"
size = [160, 120]

[[case]]
name = "from-above"
camera = "map"
size = [160, 120]
TOML
rocinante golden approve "a suite.toml" -m first
run() { rocinante golden run "a suite.toml" --sarif out.sarif --junit out.xml "$@"; }
# How many pixels differ is the renderer's: another Mesa may have one more.
counted() { sed -E 's/[0-9][0-9,]* of [0-9][0-9,]* differing/N of M differing/g; s/[0-9][0-9,]* differing/N differing/g'; }
run --github
grep -c '<testcase' out.xml
grep -c ruleIndex out.sarif || true
sed -i 's/1 1 0.1/1 1.2 0.1/' plate.urdf
{ run --github || echo "::exit $?"; } | grep '^::' |
  sed 's/link body of plate[^%]*/link body of plate .../' | counted
grep -o 'name="[a-z-]*" file="[^"]*" line="[0-9]*"' out.xml
python3 - <<'PY'
import json
run = json.load(open("out.sarif"))["runs"][0]
for result in run["results"]:
    place = result["locations"][0]["physicalLocation"]
    print(result["ruleId"], run["tool"]["driver"]["rules"][result["ruleIndex"]]["id"],
          place["artifactLocation"]["uri"], place["region"]["startLine"],
          result["message"]["text"].splitlines()[0])
PY
rm -f page.md
run --summary page.md >/dev/null || echo "exit $?"
run --summary page.md --report out >/dev/null || true
grep -c '^## ' page.md
head -n 12 page.md | sed 's/link body of plate.*/link body of plate .../; s/llvmpipe-[^`]*/llvmpipe-.../' | counted
grep -o '; pictures in.*' page.md
run --summary nowhere/page.md >/dev/null 2>said || cat said
run --github --json || echo "exit $?"
