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

# A table of several devices.
: >said
rocinante record 127.0.0.1:0 -o cell.mcap >/dev/null 2>said &
recorder=$!
until grep -qs '^recording' said; do sleep 0.02; done
port=$(sed 's/.*:\([0-9]*\) to .*/\1/' said)
printf 't,arm.j1,arm.j2,gantry.x,tray:x,tray:y,tray:z,tray:qx,tray:qy,tray:qz,tray:qw\n0,0.1,0.2,1.5,0.4,0.2,0.8,0,0,0,1\n' >cell.csv
rocinante source --csv cell.csv --run r1 --to 127.0.0.1:"$port" --quiet
kill -INT $recorder
wait $recorder
rocinante log cat cell.mcap --format json | sed -n 's/.*"text": *"\(RK1[^"]*\)".*/\1/p'
