# A signed table is kept by a recorder that trusts its key for its SOURCE, and by no other.
rocinante key make arm.key >made
sed 's/key [0-9a-f]*/key ID/' made
rocinante key make gantry.key >/dev/null
ls -l arm.key arm.key.pub | cut -c1-10
rocinante key trust arm.key.pub --source 'a?m' >trusted.toml
rocinante key trust gantry.key --source gantry >>trusted.toml
printf 't,a,b\n0,0,0\n0.01,1,1\n0.02,2,2\n' >table.csv
: >said
rocinante record 127.0.0.1:0 --trust trusted.toml -o log.mcap --json >summary.json 2>said &
recorder=$!
until grep -qs '^recording' said; do sleep 0.02; done
port=$(sed 's/.*:\([0-9]*\) to .*/\1/' said)
send() { rocinante source --csv table.csv --run r --restate 0 --to 127.0.0.1:"$port" --quiet "$@"; }
send --device arm --key arm.key
send --device arm --key gantry.key
send --device arm
kill -INT $recorder
wait $recorder
python3 -c '
import json
summary = json.load(open("summary.json"))
print(summary["packets"], "kept;", {k: n for k, n in summary["endpoints"][0]["untrusted"].items() if n})'
rocinante log verify log.mcap --trust trusted.toml
rocinante log cat log.mcap --format json | grep -c 'at=[0-9]*\\njoints'
# A player signs its own restatements and nothing else.
rocinante key make player.key >/dev/null
rocinante key trust player.key.pub --source '*' --relay >player.toml
sed 's/sources = .*/sources = []/' trusted.toml >nothing.toml
: >said
rocinante record 127.0.0.1:0 --trust player.toml -o replayed.mcap --json >summary.json 2>said &
recorder=$!
until grep -qs '^recording' said; do sleep 0.02; done
port=$(sed 's/.*:\([0-9]*\) to .*/\1/' said)
rocinante play log.mcap --to 127.0.0.1:"$port" --key player.key --quiet
kill -INT $recorder
wait $recorder
python3 -c '
import json
summary = json.load(open("summary.json"))
print(summary["restated"], {k: n for k, n in summary["endpoints"][0]["untrusted"].items() if n})'
rocinante log verify replayed.mcap --trust player.toml
echo "# refusals"
try() { "$@" >/dev/null || echo "exit $?" >&2; }
try rocinante record 127.0.0.1:0 --trust nothing.toml
try rocinante record 127.0.0.1:0 --trust missing.toml
try rocinante source --csv table.csv --device arm --to 127.0.0.1:9 --key arm.key.pub
chmod 640 arm.key
try rocinante source --csv table.csv --device arm --to 127.0.0.1:9 --key arm.key
try rocinante play log.mcap --to 127.0.0.1:9 --key arm.key
chmod 600 arm.key
try rocinante key make arm.key
try rocinante key trust arm.key
try rocinante log verify log.mcap --trust trusted.toml --at 3
