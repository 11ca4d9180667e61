rocinante source --demo --duration 0.05s --to 127.0.0.1:9 --json >report
grep -e '"source"' -e '"interrupted"' report
# Interrupted after its first packet has come.
rocinante record 127.0.0.1:0 -o log.mcap --max-packets 1 >/dev/null 2>said &
recorder=$!
until grep -qs '^recording' said; do kill -0 $recorder; sleep 0.02; done
port=$(sed 's/.*:\([0-9]*\) to .*/\1/' said)
rocinante source --demo planner --to "127.0.0.1:$port" --quiet &
source=$!
wait $recorder
kill -INT $source
wait $source
