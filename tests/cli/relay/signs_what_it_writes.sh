# A relay that trusts a source passes nothing else, and signs what it writes itself: a recorder that trusts both, the
# relay as a relay, keeps everything.
rocinante key make arm.key >/dev/null
rocinante key make hub.key >/dev/null
rocinante key trust arm.key.pub --source arm >arm.toml
rocinante key trust hub.key.pub --source '*' --relay >both.toml
cat arm.toml >>both.toml
printf 't,a,b\n0,0,0\n0.01,1,1\n0.02,2,2\n' >table.csv
rocinante record 127.0.0.1:0 --trust both.toml -o out.mcap --json >summary.json 2>recorder &
recorder=$!
until grep -qs '^recording' recorder; do kill -0 $recorder; sleep 0.05; done
to=$(grep -o '127.0.0.1:[1-9][0-9]*' recorder | sed -n 1p)
rocinante relay --from 127.0.0.1:0 --to "$to" --max-rate 1000 --restate 200ms --name hub --trust arm.toml --key hub.key \
  --json >report 2>relay &
relay=$!
until grep -qs '^sending' relay; do kill -0 $relay; sleep 0.05; done
from=$(grep -o '127.0.0.1:[1-9][0-9]*' relay | sed -n 1p)
send() { rocinante source --csv table.csv --run r --restate 0 --to "$from" --quiet --device "$@"; }
send arm --key arm.key
send thief
send thief --key arm.key
# The relay restates what it has, signed.
sleep 1
kill -INT $relay
wait $relay
kill -INT $recorder
wait $recorder
python3 - <<'PY'
import json
report, summary = json.load(open("report")), json.load(open("summary.json"))
print("applied", report["applied"], "of", report["received"])
print("not trusted:", {k: n for k, n in report["inputs"][0]["untrusted"].items() if n})
untrusted = {k: n for k, n in summary["endpoints"][0]["untrusted"].items() if n}
print("everything is trusted" if summary["packets"] + summary["restated"] >= 4 and not untrusted else (summary, untrusted))
PY
rocinante log cat out.mcap >all.txt
grep -c thief all.txt || true
rocinante log verify out.mcap --trust both.toml >verified && echo "every signature holds"
