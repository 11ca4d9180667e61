# Where damage of the log may be why a picture is what it is, nothing is judged and nothing approved.
export ROCINANTE_USER=ada
cell=$SRC/examples/demo/demo.cell.toml
cp "$SRC/examples/demo/session.mcap" whole.mcap
spoil() { python3 "$SRC/tests/cli/spoil_chunks" "$@"; }
shown() { sed 's/checksum ([0-9a-f]*, stored [0-9a-f]*)/checksum/; s/llvmpipe-[^ ]*/KEY/g; s/\.[0-9a-f]\{8\}\.png/.HASH.png/; s/, from [0-9.]* to [0-9.]* s, every/, every/'; }
spoil whole.mcap half.mcap 10 99
cat >suite.toml <<TOML
format = 1
cell = "$cell"
log = "whole.mcap"
[defaults]
size = [64, 48]
camera = "overview"
[[case]]
name = "early"
at = 5
[[case]]
name = "late"
at = 15.25
[[case]]
name = "fitted"
at = 5
camera = "fit"
[[case]]
name = "picked"
event = "picked"
[[case]]
name = "last-placed"
event = "placed"
occurrence = -1
[[case]]
name = "all"
events = "p*"
TOML
sed -i 's/^at = \(.*\)/at = "\1s"/' suite.toml
rocinante golden approve suite.toml -m first | tail -1
cp goldens/manifest.json before.json
status=0; rocinante golden run suite.toml --log half.mcap --jobs 1 --junit junit.xml --report report >said 2>&1 || status=$?
shown <said | grep -v '^report'
echo "exit $status"
grep -c '<error message="incomparable: ' junit.xml
grep -o '"verdict": "incomparable"' report/report.json | wc -l
echo "== approve"
rocinante golden approve suite.toml --log half.mcap -m again 2>&1 | shown || true
cmp before.json goldens/manifest.json && echo "nothing was approved"
echo "== session"
status=0; rocinante golden session half.mcap half.mcap "$cell" --size 64x48 >said 2>&1 || status=$?
shown <said
echo "exit $status"
status=0; rocinante golden session whole.mcap half.mcap "$cell" --no-pictures --json >answer.json 2>/dev/null || status=$?
python3 -c 'import json; a = json.load(open("answer.json")); print(a["verdict"], "damage" in a)'
echo "exit $status"
echo "== bisect"
status=0; rocinante golden bisect half.mcap "$cell" --other-log whole.mcap >said 2>&1 || status=$?
shown <said
echo "exit $status"
rocinante golden bisect half.mcap "$cell" --other-log whole.mcap --until 9s
