# A log is played to another port at 4x and recorded: the payloads are the same, source by source.
log=$SRC/tests/data/logs/version-1.mcap
: >said
rocinante record 127.0.0.1:0 -o replay.mcap >/dev/null 2>said &
recorder=$!
until grep -qs '^recording' said; do sleep 0.02; done
port=$(sed 's/.*:\([0-9]*\) to .*/\1/' said)
rocinante play "$log" --to 127.0.0.1:"$port" --speed 4 --report report.json --quiet
kill -INT $recorder
wait $recorder
stream() { grep -o '"stream_sha256": "[0-9a-f]*"' "$1"; }
rocinante log info --json "$log" >a.json
rocinante log info --json replay.mcap >b.json
stream a.json
[ "$(stream a.json)" = "$(stream report.json)" ] && echo "the player sent it"
[ "$(stream a.json)" = "$(stream b.json)" ] && echo "the recorder has it"
rocinante log diff --replay "$log" replay.mcap --speed 4 --json >diff.json && echo "exit 0"
grep -E '"(same|source|in_both|missing|extra|out_of_order)"' diff.json
# Without --speed it is still the same; the other speed is reported.
rocinante log diff --replay "$log" replay.mcap | grep -c -e '^speed .*--speed is 1, but b ran at about' -e '^replay   the same$'
# One message is missing, and a limit is exceeded.
rocinante log cut replay.mcap -o short.mcap --from 0s --until -0s >/dev/null
rocinante log diff --replay "$log" short.mcap --speed 4 >diff.txt || echo "exit $?"
tail -n 1 diff.txt
rocinante log diff --replay "$log" replay.mcap --speed 100 --within 1us >diff.txt || echo "exit $?"
tail -n 1 diff.txt
rocinante log diff --replay "$log" replay.mcap --map '/none=:5' || echo "exit $?"
