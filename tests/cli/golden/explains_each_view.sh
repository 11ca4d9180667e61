# An inset that rides on what moved: in the main view the links that moved, of the inset its camera.
export ROCINANTE_USER=ada
arm() {
  mkdir -p "$1"
  cat >"$1/arm.urdf" <<URDF
<robot name="arm">
  <link name="base"><visual><origin xyz="0 0 0.25"/><geometry><box size="0.2 0.2 0.5"/></geometry></visual></link>
  <link name="forearm"><visual><origin xyz="0.2 0 0"/><geometry><box size="0.4 0.1 0.1"/></geometry></visual></link>
  <link name="wrist"><visual><origin xyz="0.06 0 0"/><geometry><box size="0.12 0.14 0.14"/></geometry></visual></link>
  <joint name="elbow_joint" type="revolute"><parent link="base"/><child link="forearm"/><origin xyz="0.1 0 $2"/><axis xyz="0 1 0"/><limit lower="-2" upper="2" effort="1" velocity="1"/></joint>
  <joint name="wrist_joint" type="revolute"><parent link="forearm"/><child link="wrist"/><origin xyz="0.4 0 0"/><axis xyz="1 0 0"/><limit lower="-2" upper="2" effort="1" velocity="1"/></joint>
</robot>
URDF
  cat >"$1/room.urdf" <<'URDF'
<robot name="room"><link name="walls">
  <visual><origin xyz="0 2 0.5"/><geometry><box size="4 0.1 1"/></geometry><material name="red"><color rgba="0.7 0.3 0.2 1"/></material></visual>
  <visual><origin xyz="2 0 0.1"/><geometry><box size="0.3 0.3 0.2"/></geometry><material name="blue"><color rgba="0.2 0.3 0.7 1"/></material></visual>
</link></robot>
URDF
  cat >"$1/cell.toml" <<'TOML'
format = 1
[[device]]
name = "room"
model = "room.urdf"
[[device]]
name = "ur10"
model = "arm.urdf"
[[camera]]
name = "overview"
eye = [1.5, -2, 1.2]
target = [0.3, 0, 0.4]
[[camera]]
name = "wrist"
on = "ur10/wrist"
eye = [0.2, 0, 0.2]
target = [1.5, 0, -0.2]
[[inset]]
camera = "wrist"
[[inset]]
camera = "map"
corner = "bottom-left"
TOML
}
arm then 0.50
arm now 0.52
cat >suite.toml <<'TOML'
format = 1
cell = "then/cell.toml"
[[case]]
name = "at-rest"
camera = "overview"
size = [640, 480]
TOML
rocinante golden approve suite.toml -m first
why() { sed -n '/^why/,/^    |/p' | grep -v '^    |' | sed 's/\(20 mm\):.*/\1/'; }
echo "both sides are known:"
rocinante golden run suite.toml --cell now/cell.toml --report report --verbose >run.txt || why <run.txt
grep -A6 '"device"' report/report.json | grep -E '"(inset|camera|kind)"' | sort | uniq -c
echo "the same, in place:"
cp now/arm.urdf then/
rocinante golden run suite.toml --verbose >run.txt || why <run.txt
echo "a golden that was accepted before texts were kept:"
python3 - <<'PY'
import json
manifest = json.load(open("goldens/manifest.json"))
print(sorted(list(manifest["cells"].values())[0]), len(manifest.pop("texts")))
json.dump(manifest, open("goldens/manifest.json", "w"))
PY
rocinante golden run suite.toml --verbose >run.txt || why <run.txt
