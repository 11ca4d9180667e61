# A log that grows while it is followed; Ctrl-C ends it, and 0 is the answer.
log=$SRC/tests/data/logs/version-1.mcap
head -c 1500 "$log" > session.mcap
rocinante-log follow session.mcap --from-start --channel '*' --format json > followed.json &
follower=$!
head -c 2500 "$log" | tail -c 1000 >> session.mcap
tail -c +2501 "$log" >> session.mcap
wait $follower
rocinante log cat session.mcap --channel '*' --format json > stored.json
cmp stored.json followed.json
head -c 1500 "$log" > killed.mcap
: >text
rocinante-log follow killed.mcap --from-start >>text &
follower=$!
# All that a whole chunk and the open one hold.
until [ "$(wc -l <text)" = 13 ]; do kill -0 $follower; sleep 0.02; done
kill -INT $follower
wait $follower
echo "messages: $(wc -l < text)"
