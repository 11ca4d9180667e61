# What the page docs/programs/source.md shows of --log; TIME, which is that of now, as NOW.
record() {
  : >said
  rocinante record 127.0.0.1:0 -o "$1" >/dev/null 2>said &
  recorder=$!
  until grep -qs '^recording' said; do kill -0 $recorder; sleep 0.02; done
  port=$(sed 's/.*:\([0-9]*\) to .*/\1/' said)
}
printf 't,shoulder,elbow\n0,0.10,-1.5e-1\n0.004,0.1002,-0.15\n0.011,0.1010,-.149\n' >table.csv
record session.mcap
rocinante source --csv table.csv --device arm --run r1 --restate 0 --to 127.0.0.1:"$port" --quiet
kill -INT $recorder
wait $recorder

record again.mcap
rocinante source --log session.mcap --run r2 --as arm=left --loop 2 --to 127.0.0.1:"$port" --json >report 2>told
kill -INT $recorder
wait $recorder
sed "s/$port/PORT/" told
rocinante log cat again.mcap --format json | sed -n 's/.*"text": *"\(RK1[^"]*\)".*/\1/p' |
  sed 's/^\(RK1 [^ ]* [0-9]*\) [0-9.]*/\1 NOW/'
grep -e '"source"' -e '"run"' -e '"sent"' -e '"restatements"' -e '"interrupted"' report

try() {
  status=0
  rocinante source "$@" --to 127.0.0.1:9 2>said || status=$?
  tail -n 1 said
  echo "$status"
}
try --log session.mcap --source leg
try --log session.mcap --as leg=left
try --log session.mcap --as arm
try --log session.mcap --as arm=
try --log session.mcap --from 1s
try --log session.mcap --restate 1ms
try --log session.mcap --csv table.csv --device arm
try --log session.mcap --columns shoulder
try --log missing.mcap
try --csv table.csv --device arm --device leg
try --device arm
try --csv table.csv --device arm --from 1s
# Damage is named, and what is left is sent.
cp "$SRC/examples/demo/session.mcap" damaged.mcap
chmod u+w damaged.mcap
printf 'xxxxxxxx' | dd of=damaged.mcap bs=1 seek=50000 conv=notrunc status=none
status=0
rocinante source --log damaged.mcap --speed 40 --quiet --to 127.0.0.1:9 2>said || status=$?
grep -o 'fails its checksum' said
echo "$status"
