# What the recorder refuses before it begins.
. "$SRC/tests/support/blocks.sh"

block "says what it does"
rocinante record --help

block "refuses bad options"
for option in --duration=0s --duration=soon --sync=-1s --compression=lz4 --compression=zstd:99 --output=%T.mcap; do
  status=0
  rocinante record 127.0.0.1:0 "$option" || status=$?
  echo "$status"
done
ls

# A log is a file that is read from both ends, so `-` is refused.
block "refuses standard output"
rocinante record 127.0.0.1:0 -o - --duration 1ms || echo "exit $?"
rocinante log cut "$SRC/examples/demo/session.mcap" --from 0s -o - || echo "exit $?"
ls

block "refuses what is no endpoint"
for endpoint in 127.0.0.1 127.0.0.1:99999 ::1:5 'nats://localhost:4222' '239.1.2.3:5?speed=3' \
  '1.2.3.4:5?interface=lo' '239.1.2.3:0?interface=nowhere0'; do
  status=0
  rocinante record "$endpoint" -o log.mcap 2>said || status=$?
  # Every machine has other interfaces.
  sed 's/; there are .* (/; there are ... (/' said >&2
  rm said
  echo "$status"
done
ls

# A recording never begins without the cell that it was to carry: nothing is made.
block "refuses a cell that does not load"
cat >box.urdf <<'URDF'
<robot name="box"><link name="body"><visual><geometry><mesh filename="meshes/gone.obj"/></geometry></visual></link></robot>
URDF
rocinante record 127.0.0.1:0 --cell box.urdf -o session.mcap --duration 100ms || echo "exit $?"
rocinante record 127.0.0.1:0 --cell none.cell.toml -o session.mcap --duration 100ms || echo "exit $?"
rocinante record 127.0.0.1:0 --search . -o session.mcap --duration 100ms || echo "exit $?"
ls

# What cannot be, or not together, is said before a socket is bound.
block "session refusals"
for options in '--split-size 100' '--split-size lots' '--split-time 0s' '--keep 0' '--disk-quota 1kB' \
  '--split-size 2MB --disk-quota 1MB' '--keep 3 --attach-once' '--ring-on boom' '--ring 30s --split-time 1m' '--ring 0s' \
  '--ring 30s --ring-size 1MB' '--ring 30s --ring-on packets=5' '--start-on silence=2s' '--stop-on silence=soon' \
  '--start-on event=' '--status 0s' '-o %n%q.mcap' '--ring 5s -o /nowhere/at/all.mcap' '--watch cell.toml' '--ring 5s --watch-severity note' \
  '--ring 5s --watch cell.toml --watch-severity loud'; do
  status=0
  # shellcheck disable=SC2086
  rocinante record 127.0.0.1:0 $options || status=$?
  echo "$options: $status"
done
ls

block "keeps an existing log"
echo precious >log.mcap
rocinante record 127.0.0.1:0 -o log.mcap --duration 0.05s --quiet || echo "exit $?"
cat log.mcap
rocinante record 127.0.0.1:0 -o log.mcap --duration 0.05s --quiet --force
head -c 5 log.mcap | tail -c 4
echo

# A log that cannot hold its cell is none: nothing of it stays, and nothing was recorded.
block "a disk too small for the cell"
(ulimit -f 400 && rocinante record 127.0.0.1:0 --cell "$SRC/examples/demo/demo.cell.toml" -o session.mcap \
  --duration 50ms) || echo "exit $?"
ls
