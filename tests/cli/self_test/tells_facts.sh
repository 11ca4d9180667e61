# Every fact has a line; what draws, the loopback interface and this folder are as they should be. Debian 12 and 13 draw
# the known bits, another one the same but for rounding.
code=0
rocinante --self-test >facts || code=$?
awk '/^(ok|limited|missing) /{print $2}' facts
if grep -q '^[lm]' facts; then [ "$code" = 1 ]; else [ "$code" = 0 ]; fi
rocinante --self-test --json >facts.json || true
python3 - <<'PY'
import json
report = json.load(open("facts.json"))
assert report["format"] == 1 and len(report["facts"]) == 14
assert report["ok"] == all(fact["state"] == "ok" for fact in report["facts"])
state = {fact["name"]: fact["state"] for fact in report["facts"]}
print({name: state[name] for name in ("context", "key", "multicast", "files")})
for fact in report["facts"]:
    if fact["name"] == "frame" and fact["state"] not in ("ok", "limited"):
        print(fact)
    assert fact["says"], fact
    assert (fact["state"] == "ok") == (fact["advice"] == ""), fact
PY
rocinante --self-test --only context,key | cut -c1-16
rocinante self-test --only key >by-verb
rocinante --self-test --only key | diff by-verb -
