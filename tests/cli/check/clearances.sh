# Two arms that come too near on the way from one packet to the next, and once are too near at one;
# the least distance of those that keep theirs is listed, too.
cat >cell.toml <<'TOML'
format = 1
[[device]]
name = "left"
model = "arm.urdf"
[[device]]
name = "right"
model = "arm.urdf"
pose = { xyz = [2.3, 0, 0], rpy_deg = [0, 0, 180] }
[[device]]
name = "far"
model = "arm.urdf"
pose = { xyz = [0, 4, 0] }
[[clearance]]
name = "arms"
between = ["left/hand", "right"]
min_m = 0.15
[[clearance]]
between = ["left", "far"]
min_m = 0.15
TOML
cat >arm.urdf <<'URDF'
<robot name="arm">
  <link name="base"/>
  <link name="hand">
    <collision><origin xyz="1 0 0"/><geometry><sphere radius="0.1"/></geometry></collision>
  </link>
  <joint name="turn" type="revolute">
    <parent link="base"/> <child link="hand"/> <axis xyz="0 0 1"/>
    <limit lower="-2" upper="2" effort="1" velocity="9"/>
  </joint>
</robot>
URDF
rocinante record 127.0.0.1:0 -o log.mcap --cell cell.toml --max-packets 3 >/dev/null 2>said &
until grep -qs '^recording' said; do kill -0 $!; sleep 0.05; done
to="/dev/udp/127.0.0.1/$(sed -n 's/^recording .*:\([0-9]*\) to .*/\1/p' said)"
# Above each other between the first two: 0.1 m apart. Only the third is too near at a packet.
sequence=0
for joint in -0.5 0.6 0.1; do
  printf 'RK1 me@a %d -\njoints left %s\njoints right 0\njoints far 0\n' $sequence $joint >packet
  cat packet >"$to"  # in one write: one datagram
  sequence=$((sequence + 1))
done
wait $!
rocinante check cell.toml log.mcap --format json >report.json || echo "exit $?"
python3 -c '
import json
for c in json.load(open("report.json"))["clearances"]:
    print(json.dumps([c["name"], c["least_m"], c["violations"], len(c["spans"]), c["links"]], separators=(",", ":")))'
# A baseline keeps how near they came, in millimetres, nearer being worse.
rocinante check cell.toml log.mcap --baseline known.json --update-baseline >/dev/null
grep -o '"rule":"clearance.too-close".*' known.json
sed -i 's/"worst":-/"worst":-9/' known.json
rocinante check cell.toml log.mcap --baseline known.json --quiet | sed 1d || echo "exit $?"
