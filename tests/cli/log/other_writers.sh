# MCAP files of other writers are described correctly, and every tool keeps their messages.
cat > make.py <<'PYTHON'
import os, sys
sys.path.insert(0, os.environ['SRC'] + '/tests/support')
from mcap_file import McapFile
chatter = (0, '/chatter', 'cdr', {'offered_qos_profiles': '-'})
start = 1770000000 * 10**9
def log(tenths):
    made = McapFile('ros2', 'libmcap 1.4')
    made.chunk([(chatter, start + i * 10**8, b'\0\1text %d' % i) for i in tenths])
    return made
log(range(20)).save('whole.mcap')
log(range(20)).save('no_summary.mcap', summary=False)
log(range(20, 30)).save('later.mcap')
cut = log(range(20)).bytes
open('cut.mcap', 'wb').write(cut)
PYTHON
python3 make.py
for log in whole no_summary cut; do
  { rocinante log info $log.mcap || true; } | grep complete
  rocinante log info --json $log.mcap >info.json && status=0 || status=$?
  grep -E '"(complete|profile|library)"' info.json
  echo "exit $status"
done
sums() { { rocinante log info --json "$1" || true; } | grep -E '"(messages|stream_sha256)": .*,$' | tail -n 1; }
sums whole.mcap
try() { "$@" && echo "exit 0" || echo "exit $?"; }
try rocinante log cut whole.mcap -o part.mcap --from 0.5s --until 1s
try rocinante log filter whole.mcap -o same.mcap --channel '/cha*'
try rocinante log recover cut.mcap -o recovered.mcap
try rocinante log merge whole.mcap later.mcap -o both.mcap
try rocinante log split no_summary.mcap -o pieces/ --time 1s
try rocinante log merge pieces/*.mcap -o again.mcap
for made in same recovered again; do sums $made.mcap; done
for made in part same recovered both again; do rocinante log doctor $made.mcap | cut -d'(' -f1; done
rocinante play whole.mcap --channel /chatter --to 127.0.0.1:9 --asap --json 2>play.err | grep -E '"(sent|restatements|stream_sha256)"' || cat play.err
