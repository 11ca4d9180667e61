# Six seconds of the motion, live over loopback, fit the cell: names, counts, limits, rates.
rocinante record 127.0.0.1:0 -o live.mcap >summary 2>said &
recorder=$!
until grep -qs '^recording' said; do kill -0 $recorder; sleep 0.05; done
port=$(sed 's/.*:\([0-9]*\) to .*/\1/' said)
rocinante source --demo all --duration 6s --to "127.0.0.1:$port" --quiet
kill -INT $recorder
wait $recorder
rocinante check "$SRC/examples/demo/demo.cell.toml" live.mcap | tail -n 1
