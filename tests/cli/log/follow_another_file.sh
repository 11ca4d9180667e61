# A log is followed from its first byte on, and not where it was truncated or another has its name.
log=$SRC/tests/data/logs/version-1.mcap
rocinante log cat "$log" --channel '*' --format json >stored.json
: >begun.mcap
rocinante-log follow begun.mcap --from-start --channel '*' --format json >followed.json &
follower=$!
for part in 1 2 3 4 5 6 7 8; do head -c $((part * 400)) "$log" | tail -c 400 >>begun.mcap; done
tail -c +3201 "$log" >>begun.mcap
wait $follower
cmp stored.json followed.json

# Starts to follow the first part of the log, and waits until it has shown what is there.
begin() {
  head -c 1500 "$log" >"$1"
  : >text
  rocinante-log follow "$1" --from-start >>text &
  follower=$!
  until [ "$(wc -l <text)" = 13 ]; do kill -0 $follower; sleep 0.02; done
}
begin short.mcap
truncate -s 1000 short.mcap
wait $follower || echo "truncated: exit $?"
begin replaced.mcap
cp "$log" other.mcap
mv other.mcap replaced.mcap
wait $follower || echo "replaced: exit $?"
begin gone.mcap
rm gone.mcap
kill -INT $follower
wait $follower
echo "deleted: exit $?"

# What is broken in it is left out.
{ head -c 700 "$log"; head -c 60 /dev/zero; tail -c +701 "$log"; } >broken.mcap
rocinante log follow broken.mcap --from-start --format json >followed.json || echo "broken: exit $?"
rocinante log cat broken.mcap --format json >cat.json || echo "cat: exit $?"
cmp cat.json followed.json
