# The first moment and the last that a log can hold: read, cut, split and played. One behind it is damage.
cat > make.py <<'PYTHON'
import os, sys
sys.path.insert(0, os.environ['SRC'] + '/tests/support')
from mcap_file import McapFile
arm = (1, '/udp/5000/arm', 'rk1', {'source': 'arm'})
for name, times in [('both_ends', [0, 2**63 - 2]), ('beyond', [2**63 - 20, 2**63 - 2, 2**63 - 1])]:
    log = McapFile('rocinante', 'rocinante').session(times[0])
    log.chunk([(arm, time, b'RK1 arm %d -\njoints puma %d' % (i, i)) for i, time in enumerate(times)])
    log.metadata('rocinante.end', {'reason': 'stopped', 'session_id': 's', 'origin_ns': str(times[0])})
    log.save(name + '.mcap')
PYTHON
python3 make.py
try() { "$@" 2>&1 && echo "exit 0" || echo "exit $?"; }
for log in both_ends beyond; do
  try rocinante log cat $log.mcap
  try rocinante log cut $log.mcap -o $log-cut.mcap --from 0s
  try rocinante log split $log.mcap -o $log-pieces/ --time 1s
  try rocinante log state $log.mcap --at -0s
  { rocinante play $log.mcap --to 127.0.0.1:9 --asap --json 2>play.err || echo "exit $?" >>play.err; } | grep -E '"(sent|until_ns)"'
  grep -v ^playing play.err || true
done
