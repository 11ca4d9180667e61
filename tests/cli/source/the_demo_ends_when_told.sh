rocinante source --demo --duration 0.05s --to 127.0.0.1:9 --json >report
grep -e '"source"' -e '"interrupted"' report
rocinante source --demo planner --to 127.0.0.1:9 --quiet &
source=$!
sleep 0.3
kill -INT $source
wait $source
