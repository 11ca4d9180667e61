# What the page docs/programs/source.md shows.
: >said
rocinante record 127.0.0.1:0 -o log.mcap >/dev/null 2>said &
recorder=$!
until grep -qs '^recording' said; do sleep 0.02; done
port=$(sed 's/.*:\([0-9]*\) to .*/\1/' said)
printf 't,shoulder,elbow,note\n0,0.10,-1.5e-1,start\n0.004,0.1002,-0.15,\n0.011,0.1010,-.149,end\n' >table.csv
rocinante source --csv table.csv --device arm --columns shoulder,elbow --run r1 --restate 10ms \
  --to 127.0.0.1:"$port" --json --quiet >report
kill -INT $recorder
wait $recorder
rocinante log cat log.mcap --format json | sed -n 's/.*"text": *"\(RK1[^"]*\)".*/\1/p'
grep -e '"source"' -e '"run"' -e '"sent"' -e '"bytes"' -e '"restatements"' -e stream report
