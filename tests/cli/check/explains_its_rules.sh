# Every rule is listed with its severity, and explained by its page.
rocinante check --list-rules | grep -E ' (device.undriven|joint.limit|source.restart) '
rocinante check --list-rules --json | python3 -c '
import json, sys
rules = json.load(sys.stdin)["rules"]
print(len(rules) > 100, [r for r in rules if r["rule"] == "joint.limit"])'
rocinante check --explain joint.limit | sed -n '1,3p; /^\*\*Severity/,$p'
rocinante check --explain joint.limits || echo "exit $?"
rocinante check || echo "exit $?"
