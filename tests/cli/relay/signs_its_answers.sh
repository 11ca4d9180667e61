# A recorder with --trust believes a relay that signs its answers, records what it forwards and greets with, and does not
# subscribe at one that does not sign.
rocinante key make arm.key >/dev/null
rocinante key make hub.key >/dev/null
rocinante key trust arm.key.pub --source arm >both.toml
rocinante key trust hub.key.pub --source '*' --relay >>both.toml
printf 't,a,b\n0,0,0\n0.01,1,1\n0.02,2,2\n' >table.csv
# serve NAME [OPTION...]: starts a relay; its ports are $from and $at.
serve() {
  rocinante relay --from 127.0.0.1:0 --serve 127.0.0.1:0 --trust both.toml --name "$@" --json >"$1.json" 2>"$1.said" &
  relay=$!
  until grep -qs '^serving' "$1.said"; do kill -0 $relay; sleep 0.05; done
  from=$(grep '^listening' "$1.said" | grep -o '127.0.0.1:[1-9][0-9]*')
  at=$(grep '^serving' "$1.said" | grep -o '127.0.0.1:[1-9][0-9]*')
}
# keep NAME SENTENCE: records what the relay sends; waits until the recorder says SENTENCE.
keep() {
  rocinante record "subscribe://$at" --trust both.toml -o "$1.mcap" --json >"$1.kept" 2>"$1.heard" &
  recorder=$!
  until grep -qs "$2" "$1.heard"; do kill -0 $recorder; sleep 0.05; done
}
# stop NAME
stop() {
  kill -INT $recorder
  wait $recorder || echo "recorder: exit $?"
  kill -INT $relay
  wait $relay
  sed "s/$at/HOST:PORT/" "$1.heard" | grep 'HOST:PORT.*relay' || true
}
send() { rocinante source --csv table.csv --run "$1" --restate 0 --to "$from" --quiet --device arm --key arm.key; }

echo "# signs"
serve hub --key hub.key
send first
keep hub '^subscribed'
# The greeting is in the log when the last datagram of the second run is.
send second
until grep -q 'arm@second 3 ' <(rocinante log cat hub.mcap 2>/dev/null); do kill -0 $recorder; sleep 0.1; done
stop hub
rocinante log verify hub.mcap --trust both.toml >verified && echo "every signature holds"

echo "# does not sign"
serve plain
keep plain 'not trusted'
stop plain
python3 - <<'PY'
import json
for name in "hub", "plain":
    kept, relay = json.load(open(f"{name}.kept")), json.load(open(f"{name}.json"))
    untrusted = kept["endpoints"][0]["untrusted"]
    print(name, "untrusted:", sorted(k for k, n in untrusted.items() if n), "subscribed:", relay["subscribers"]["most"],
          "greeted:", kept["restated"] > 0)
PY
