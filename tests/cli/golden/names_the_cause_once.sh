# Frames that fail for one cause are one block: its sentence, then a line a frame.
export ROCINANTE_USER=ada
arm() {
  cat >arm.urdf <<URDF
<robot name="arm">
  <link name="base"><visual><origin xyz="0 0 0.25"/><geometry><box size="0.2 0.2 0.5"/></geometry></visual></link>
  <link name="forearm"><visual><origin xyz="0.2 0 0"/><geometry><sphere radius="$2"/></geometry>
    <material name="red"><color rgba="$3 0.1 0.1 1"/></material></visual></link>
  <joint name="elbow_joint" type="revolute"><parent link="base"/><child link="forearm"/><origin xyz="0.1 0 $1"/><axis xyz="0 1 0"/><limit lower="-2" upper="2" effort="1" velocity="1"/></joint>
</robot>
URDF
}
lamp() {
  cat >lamp.urdf <<URDF
<robot name="lamp"><link name="bulb"><visual><geometry><box size="0.3 0.3 $1"/></geometry></visual></link></robot>
URDF
}
arm 0.50 0.1 0.9
lamp 0.3
cat >cell.toml <<'TOML'
format = 1
[[device]]
name = "ur10"
model = "arm.urdf"
[[device]]
name = "lamp"
model = "lamp.urdf"
pose = { xyz = [20, 0, 0] }
[[camera]]
name = "front"
eye = [1.5, -2, 1.2]
target = [0.3, 0, 0.4]
[[camera]]
name = "side"
eye = [2, 1, 1]
target = [0.3, 0, 0.4]
[[camera]]
name = "lamp"
eye = [20, -2, 1]
target = [20, 0, 0]
TOML
{
  printf 'format = 1\ncell = "cell.toml"\n[defaults]\nsize = [96, 72]\nsamples = 1\n'
  for name in a b c; do printf '[[case]]\nname = "front-%s"\ncamera = "front"\n' $name; done
  for name in a b c; do printf '[[case]]\nname = "side-%s"\ncamera = "side"\n' $name; done
} >suite.toml
rocinante golden approve suite.toml -m first | tail -1
# How many pixels differ is the renderer's.
counted() { sed -E 's/[0-9][0-9,]* of [0-9][0-9,]* differing/N of M differing/g; s/[0-9][0-9,]* differing/N differing/g; s/\([-+]?[0-9.]+, [-+]?[0-9.]+\) px/(X, Y) px/'; }
run() { { rocinante golden run "${suite:-suite.toml}" "$@" || echo "exit $?"; } | counted; }
echo "one cause:"
arm 0.52 0.1 0.9
run --junit out.xml --sarif out.sarif --summary page.md --github
grep -o 'message="[^"]*"' out.xml | sort | uniq -c
python3 - <<'PY'
import json
for result in json.load(open("out.sarif"))["runs"][0]["results"]:
    print(result["message"]["text"].splitlines()[0])
PY
sed -n 3p page.md
run --verbose --only front-a | grep -v '^    |'
echo "a comment, and nothing else:"
arm 0.50 0.1 0.9
sed -i 's/<robot name="arm">/<!-- of today -->&/' arm.urdf
run | tail -1
echo "with it, another size and another colour:"
arm 0.50 0.12 0.5
run --only front-a
echo "two causes, each in its own frames:"
arm 0.52 0.1 0.9
printf '[[case]]\nname = "lamp"\ncamera = "lamp"\n' >>suite.toml
cp lamp.urdf kept.urdf
arm 0.50 0.1 0.9
rocinante golden approve suite.toml --only lamp -m lamp | tail -1
arm 0.52 0.1 0.9
lamp 0.4
run
echo "a colour, where the log is given too:"
arm 0.50 0.1 0.9
cp "$SRC/examples/demo/session.mcap" .
cat >moment.toml <<'TOML'
format = 1
cell = "arm.urdf"
log = "session.mcap"
goldens = "moments"
[[case]]
name = "moment"
at = "2s"
size = [96, 72]
TOML
rocinante golden approve moment.toml -m first 2>/dev/null | tail -1
arm 0.50 0.1 0.5
suite=moment.toml; run --log session.mcap 2>/dev/null | sed -n 1p
echo "the session, whose figures differ from frame to frame:"
cp -r "$SRC/examples/demo/demo.cell.toml" "$SRC/examples/demo/arm" "$SRC/examples/demo"/*.urdf "$SRC/examples/demo"/*.obj \
  "$SRC/examples/demo"/*.mtl "$SRC/examples/demo/textures" .
rocinante log filter session.mcap --source gantry --source planner -o others.mcap >made.txt
rocinante log cut session.mcap --until 13s -o begin.mcap >made.txt
rocinante log merge begin.mcap others.mcap -o still.mcap >made.txt || true
cat >demo.toml <<'TOML'
format = 1
cell = "demo.cell.toml"
log = "session.mcap"
goldens = "demo"
[defaults]
size = [96, 72]
[[case]]
name = "early"
at = "14s"
[[case]]
name = "late"
at = "15s"
TOML
rocinante golden approve demo.toml -m first | tail -1
suite=demo.toml; run --log still.mcap 2>/dev/null
