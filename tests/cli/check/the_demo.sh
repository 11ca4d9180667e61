# What we ship ourselves raises no alarm, not even a note: the cell alone, with its recording, and
# the recording with the cell that it was made with.
cell="$SRC/examples/demo/demo.cell.toml" log="$SRC/examples/demo/session.mcap"
rocinante check "$cell" --fail-on note --quiet | sed "s#$SRC/##g"
rocinante check "$cell" "$log" --fail-on note --json |
  python3 -c 'import json,sys; r=json.load(sys.stdin); print(r["verdict"], r["packets"], r["errors"], r["warnings"], r["notes"], r["findings"])'
