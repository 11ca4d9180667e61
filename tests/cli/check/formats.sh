# Each format on standard output, and several at once into files.
cat >cell.toml <<'TOML'
format = 1
[[device]]
name = "arm"
model = "arm.urdf"
colour = "#ff0000"
TOML
cat >arm.urdf <<'URDF'
<robot name="arm">
  <link name="base"/>
  <link name="hand"/>
  <joint name="turn" type="revolute"> <parent link="base"/> <child link="hand"/> </joint>
</robot>
URDF
rocinante check cell.toml || echo "exit $?"
rocinante check cell.toml --quiet || echo "exit $?"
rocinante check cell.toml --format github || echo "exit $?"
rocinante check cell.toml --format json | python3 -c '
import json, sys
report = json.load(sys.stdin)
for f in report["findings"]:
    print(report["verdict"], f["rule"], f["severity"], f["file"], f["line"], f["count"], f["first_s"])' || echo "exit $?"
rocinante check cell.toml -o junit=check.xml -o sarif=check.sarif -o text=check.txt --quiet || echo "exit $?"
cat check.txt
python3 - <<'PY'
import json
import xml.etree.ElementTree as xml
suites = xml.parse("check.xml").getroot()
suite = suites[0]
cases = suite.findall("testcase")
failed = [c for c in cases if c.find("failure") is not None]
print(suites.tag, suite.get("tests") == str(len(cases)), suite.get("failures"), [c.get("name") for c in failed])
print(failed[0].find("failure").text.splitlines()[0])
log = json.load(open("check.sarif"))
run = log["runs"][0]
for result in run["results"]:
    rule = run["tool"]["driver"]["rules"][result["ruleIndex"]]
    place = result["locations"][0]["physicalLocation"]
    print(log["version"], rule["id"] == result["ruleId"], result["level"], result["ruleId"],
          place["artifactLocation"]["uri"], place["region"])
PY
rocinante check cell.toml -o junit=check.xml || echo "exit $?"
rocinante check cell.toml -o junit=check.xml --force --quiet || echo "exit $?"
rocinante check cell.toml -o yaml=check.yaml || echo "exit $?"
