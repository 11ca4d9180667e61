# A recorder that was killed leaves a log without a summary: a note, and no reason to say no.
cat >box.cell.toml <<'TOML'
format = 1
[[device]]
name = "box"
model = "box.urdf"
TOML
cat >box.urdf <<'URDF'
<robot name="box"><link name="body"><visual><geometry><box size="1 1 1"/></geometry></visual></link></robot>
URDF
rocinante record 127.0.0.1:0 -o log.mcap >/dev/null 2>said &
recorder=$!
until grep -qs '^recording' said; do kill -0 $recorder; sleep 0.05; done
port=$(sed 's/.*:\([0-9]*\) to .*/\1/' said)
for i in 1 2 3; do
  printf 'RK1 me@a %s -\npose box 0 0 %s 0 0 0 1\n' "$i" "$i" >packet
  cat packet >"/dev/udp/127.0.0.1/$port"  # in one write: one datagram
done
# Killed when what was said stands in the file.
until [ "$(rocinante log cat log.mcap 2>/dev/null | grep -c 'me@a\|RK1 me')" = 3 ]; do kill -0 $recorder; sleep 0.05; done
# The shell tells of a killed child whenever it notices: on an error stream that goes nowhere.
{ kill -KILL $recorder; wait $recorder || true; } 2>/dev/null
rocinante check box.cell.toml log.mcap | sed 's/over [0-9.]* s/over SPAN/'
