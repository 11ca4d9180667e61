# The distances of a cell's clearances as columns, as `check` says them; a ball inside a box
# penetrates it, although no surfaces touch.
cat >cell.toml <<'TOML'
format = 1
[[device]]
name = "ball"
model = "ball.urdf"
[[device]]
name = "box"
model = "box.urdf"
pose = { xyz = [3, 0, 0] }
[[device]]
name = "post"
model = "box.urdf"
pose = { xyz = [0, 3, 0] }
[[clearance]]
name = "gap"
between = ["ball", "*"]
min_m = 0.5
TOML
cat >ball.urdf <<'URDF'
<robot name="ball"><link name="ball"><collision><geometry><sphere radius="0.1"/></geometry></collision></link></robot>
URDF
cat >box.urdf <<'URDF'
<robot name="box"><link name="box"><collision><geometry><box size="1 1 1"/></geometry></collision></link></robot>
URDF
rocinante record 127.0.0.1:0 -o log.mcap --cell cell.toml --max-packets 3 >/dev/null 2>said &
until grep -qs '^recording' said; do kill -0 $!; sleep 0.05; done
to="/dev/udp/127.0.0.1/$(sed -n 's/^recording .*:\([0-9]*\) to .*/\1/p' said)"
sequence=0
for x in 0 2.3999 3; do
  printf 'RK1 me@a %d -\npose ball %s 0 0 0 0 0 1\n' $sequence $x >packet
  cat packet >"$to"  # in one write: one datagram
  sequence=$((sequence + 1))
done
wait $!
rocinante log table log.mcap --clearance | sed 's/^[0-9.e-]*,//'
echo "== of one device"
rocinante log table log.mcap --clearance --device 'ball' --every 1000s -o ball.npz
rocinante log table log.mcap --clearance --device 'b*' -o table.csv
rocinante source --csv table.csv --speed 1000 --run r1 --to 127.0.0.1:9 --quiet && echo sent
echo "== check says the same"
rocinante check cell.toml log.mcap --format json >report.json || echo "exit $?"
python3 -c '
import json
for c in json.load(open("report.json"))["clearances"]:
    print(c["devices"], c["least_m"], c["penetrating"])'
echo "== refused"
try() { rocinante log table "$@" || echo "exit $?"; }
cp "$SRC/tests/data/logs/version-1.mcap" session.mcap
try session.mcap --clearance
try log.mcap --clearance --cell ball.urdf
