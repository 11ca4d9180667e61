# Cameras, tags, shards and jobs: which frames are drawn, and that neither order nor jobs change an answer.
export ROCINANTE_USER=ada
cp "$SRC/examples/demo/session.mcap" session.mcap
cat >suite.toml <<TOML
format = 1
cell = "$SRC/examples/demo/demo.cell.toml"
log = "session.mcap"
[defaults]
size = [96, 64]
samples = 1
[[case]]
name = "tour"
every = "4s"
camera = ["overview", "top"]
tags = ["slow"]
[[case]]
name = "picked"
events = "pick*"
after = "160ms"
layers = []
[[case]]
name = "last"
event = "picked"
occurrence = -1
tags = ["arm"]
TOML
list() { rocinante golden list suite.toml "$@" | awk '{print $1, $2, $3}'; }
list || echo "exit $?"
list --tag arm || echo "exit $?"
list --not-tag slow --not-tag arm || echo "exit $?"
list --shard 2/3 || echo "exit $?"
rocinante golden list suite.toml --shard 4/4 || echo "exit $?"
rocinante golden list suite.toml --shard 4/3 || echo "exit $?"
rocinante golden approve suite.toml -m first | tail -1
for jobs in 1 2 3; do rocinante golden run suite.toml --jobs $jobs >"jobs-$jobs.txt"; done
cmp jobs-1.txt jobs-2.txt && cmp jobs-1.txt jobs-3.txt && tail -1 jobs-1.txt
# Shards put together answer what one run does.
for i in 1 2 3; do rocinante golden run suite.toml --shard $i/3 --report part-$i >/dev/null; done
rocinante golden report part-2 part-1 part-3 --report whole | sed '/^report/d'
rocinante golden report part-1 part-3 || echo "exit $?"
rocinante golden report part-1 part-1 || echo "exit $?"
rocinante golden report part-1 part-2 part-3 --json | python3 -c '
import json, sys
whole = json.load(sys.stdin)
print(whole["verdict"], whole["counts"]["same"], "shard" in whole)'
echo '{"format": 1, "frames": [{"name": "../../up", "verdict": "same"}]}' >part-1/report.json
rocinante golden report part-1 part-2 part-3 || echo "exit $?"
