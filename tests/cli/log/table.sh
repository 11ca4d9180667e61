# Joint values and poses as columns; what is not known is empty and told.
cp "$SRC/tests/data/logs/version-1.mcap" session.mcap
rocinante log table session.mcap | sed -n 1,4p
rocinante log table "$SRC/examples/demo/session.mcap" --cell "$SRC/examples/demo/demo.cell.toml" \
  --every 5s -o demo.csv
cat demo.csv
rocinante log table "$SRC/examples/demo/session.mcap" --device canister --from 4s | sed -n 1,2p ||
  echo "exit $?"
rocinante log table "$SRC/examples/demo/session.mcap" --cell "$SRC/examples/demo/demo.cell.toml" \
  --device 'ga*' --changes -o gantry.npy --json
echo "== what a table says is read back"
rocinante source --csv demo.csv --speed 1000 --run r1 --to 127.0.0.1:9 --quiet && echo sent
echo "== refused"
try() { rocinante log table "$@" || echo "exit $?"; }
try session.mcap -o table.txt
try session.mcap -o demo.csv
try session.mcap --every 0
try session.mcap --every 1s --changes
try session.mcap --device nobody
try session.mcap --json
try session.mcap --search .
