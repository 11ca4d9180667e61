# A table becomes a log; a part of it is played twice and recorded again.
record() {
  : >said
  rocinante record 127.0.0.1:0 -o "$1" >/dev/null 2>said &
  recorder=$!
  until grep -qs '^recording' said; do sleep 0.02; done
  port=$(sed 's/.*:\([0-9]*\) to .*/\1/' said)
}
stop() {
  kill -INT $recorder
  wait $recorder
}
printf 't,a,b\n0,1.0,2\n0.2,1.5,3\n0.4,2.0,4\n0.6,2.5,5\n' >table.csv
record first.mcap
rocinante source --csv table.csv --device arm --run r1 --to 127.0.0.1:"$port" --quiet
stop

record second.mcap
rocinante play first.mcap --from 0.1s --until 0.5s --loop 2 --to 127.0.0.1:"$port" --report report.json \
  >summary 2>line
stop
sed 's/127.0.0.1:[0-9]*/HOST:PORT/' line
sed -e 's/127.0.0.1:[0-9]*/HOST:PORT/' -e 's/ in .*s, [0-9.]*\/s/ in T/' -e 's/late by.*/late by X/' summary
grep -v -e '_ns"' -e '"p[0-9]*"' -e '"max"' -e '^    "[0-9]*":' -e drift -e duration -e rate -e timing -e scheduling -e '"to"' report.json
rocinante log cat second.mcap --format json | grep -o 'joints arm [0-9. ]*'

# An existing report is left alone, and that is said before anything is sent.
rocinante play first.mcap --report report.json --to 127.0.0.1:"$port" || echo "exit $?"
