# A live source that stops: the window says so and shows the last known state, which the kept log has whole; when the
# source is back, the sentence goes and the picture follows.
export ASAN_OPTIONS=detect_leaks=0 XDG_CACHE_HOME=$PWD/cache
demo=$SRC/examples/demo
port=$((20000 + ($$ + 13) % 20000))
cat >script.txt <<'SCRIPT'
panels off
frame 1
screenshot listens.png
await-line nothing received for the last 2 s
await-line the sender stopped, or the network path is broken; the last known state is shown
evidence gone.png
save gone.mcap
await-line saved: gone.mcap
dismiss
screenshot stopped.png
await-line
await 8s
save back.mcap
SCRIPT
appears() {
  until [ -s "$1" ]; do
    kill -0 $viewer || exit 1
    sleep 0.05
  done
}
with_display rocinante view "$demo/demo.cell.toml" --live "127.0.0.1:$port" --size 320x240 --profile reproducible \
  --script script.txt &
viewer=$!
appears listens.png
rocinante source --demo all --duration 2s --run first --json --to "127.0.0.1:$port" >sent.json 2>/dev/null
appears stopped.png
rocinante source --demo all --duration 300s --run second --to "127.0.0.1:$port" >/dev/null 2>&1 &
source=$!
wait $viewer && echo "view: exit 0" || echo "view: exit $?"
kill $source
wait $source 2>/dev/null || true
python3 - <<'PYTHON'
import json, subprocess
def ask(*words): return json.loads(subprocess.check_output(["rocinante", "log", "info", "--json", *words]))
report = json.load(open("sent.json"))
first, both = ask("gone.mcap"), ask("back.mcap")
print("all of the first part is kept:", first["messages"] >= report["sent"])
print("and what came after it:", both["messages"] > first["messages"])
PYTHON
# What was shown is the end of what was kept.
end=$(python3 -c 'import json, subprocess
print(json.loads(subprocess.check_output(["rocinante", "log", "info", "--json", "gone.mcap"]))["duration_s"])')
rocinante render gone.mcap --at "${end}s" --size 320x240 -o end.png
rocinante golden compare gone.png end.png
