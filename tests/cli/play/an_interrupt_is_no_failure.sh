: >said
rocinante record 127.0.0.1:0 -o log.mcap >/dev/null 2>said &
recorder=$!
until grep -qs '^recording' said; do sleep 0.02; done
port=$(sed 's/.*:\([0-9]*\) to .*/\1/' said)
printf 't,a\n0,1\n0.01,2\n0.3,3\n' >table.csv
rocinante source --csv table.csv --device arm --to 127.0.0.1:"$port" --quiet
kill -INT $recorder
wait $recorder
# At a hundredth of the speed it would take half a minute.
rocinante play log.mcap --to 127.0.0.1:"$port" --speed 0.01 --json >report 2>said &
player=$!
until grep -qs '^playing' said; do sleep 0.02; done
kill -INT $player
status=0
wait $player || status=$?
echo "exit $status"
grep interrupted report
sed 's/127.0.0.1:[0-9]*/HOST:PORT/' said
# Outside the recorded range there is nothing to play.
rocinante play log.mcap --from 10s --until 20s --to 127.0.0.1:"$port" || echo "exit $?"
rocinante play log.mcap --from 0.2s --until 0.1s --to 127.0.0.1:"$port" || echo "exit $?"
