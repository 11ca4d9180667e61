# A source, a relay and a recorder: nothing is lost, and SEQUENCE has no gap.
rocinante record 127.0.0.1:0 -o out.mcap >recorded 2>recorder &
recorder=$!
until grep -qs '127.0.0.1:[1-9]' recorder; do kill -0 $recorder; sleep 0.05; done
to=$(grep -o '127.0.0.1:[1-9][0-9]*' recorder | sed -n 1p)
rocinante relay --from 127.0.0.1:0 --to "$to" --json >report 2>relay &
relay=$!
until grep -qs '^sending' relay; do kill -0 $relay; sleep 0.05; done
from=$(grep -o '127.0.0.1:[1-9][0-9]*' relay | sed -n 1p)
rocinante source --demo all --to "$from" --speed 4 --duration 8s --quiet --json >sent
kill -INT $relay
wait $relay
kill -INT $recorder
wait $recorder
python3 - <<'PY'
import json
sent, report = json.load(open("sent")), json.load(open("report"))
whole = report["outputs"][0]
total = sent["sent"] + sent["restatements"]
print(report["received"] == total, whole["forwarded"] == report["applied"] == total, whole["whole"], report["lost"])
PY
