# A log for other tools; what those formats cannot hold is named.
cp "$SRC/examples/demo/session.mcap" session.mcap
cell="$SRC/examples/demo/demo.cell.toml"
rocinante log export session.mcap "$cell" --foxglove -o foxglove.mcap --json --until 1s
rocinante log export session.mcap "$cell" --ros2 -o bag.mcap
rocinante log info bag.mcap | sed -n 1,4p || true
rocinante log doctor foxglove.mcap | grep -v profile || true
echo "== without a cell, and with other datagrams"
cp "$SRC/tests/data/logs/version-1.mcap" version-1.mcap
rocinante log export version-1.mcap --foxglove -o bare.mcap || echo "exit $?"
rocinante log export version-1.mcap --foxglove --raw -o raw.mcap || echo "exit $?"
echo "== a log that carries its cell"
rocinante log attach session.mcap --cell "$cell" -o carries.mcap >/dev/null
rocinante log export carries.mcap --foxglove -o carried.mcap
rocinante log extract carried.mcap --list
echo "== a capture is read back as the same log"
rocinante log export session.mcap --pcap -o session.pcap
rocinante record pcap://./session.pcap -o back.mcap --quiet
for log in session back; do rocinante log info --json $log.mcap | grep content_sha256; done
echo "== refused"
try() { rocinante log export "$@" || echo "exit $?"; }
try session.mcap -o x.mcap
try session.mcap --ros2 --pcap -o x.mcap
try session.mcap "$cell" --pcap -o x.pcap
try session.mcap --foxglove -o bag.mcap
try session.mcap missing.cell.toml --foxglove -o x.mcap
try session.mcap --foxglove -o session.mcap --force
(ulimit -f 40; try session.mcap "$cell" --foxglove -o full.mcap)
(ulimit -f 40; try session.mcap --pcap -o full.pcap)
ls
