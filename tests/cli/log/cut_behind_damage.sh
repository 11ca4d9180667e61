# A piece that begins after damage begins with a state that may be outdated: this is reported, and so are hidden events.
python3 "$SRC/tests/cli/spoil_chunks" "$SRC/examples/demo/session.mcap" half.mcap 10 12
shown() { sed 's/checksum ([0-9a-f]*, stored [0-9a-f]*)/checksum/'; }
{ rocinante log cut half.mcap --from 15s --until 16s -o late.mcap 2>&1 || echo "exit $?"; } | shown
rocinante log cut half.mcap --from 5s --until 6s -o early.mcap
{ rocinante log cut half.mcap --from-event picked --until 6s -o picked.mcap 2>&1 || echo "exit $?"; } | shown
