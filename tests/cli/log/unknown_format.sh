# A log of a format that this program does not know: every reader says so, and nothing is copied but by recover.
cat > make.py <<'PYTHON'
import os, sys
sys.path.insert(0, os.environ['SRC'] + '/tests/support')
from mcap_file import McapFile
start = 1770000000 * 10**9
arm = (1, '/udp/5000/arm', 'rk1', {'source': 'arm'})
log = McapFile('rocinante', 'rocinante 9.0')
log.session(start, '9').chunk([(arm, start + i, b'RK1 arm %d -\njoints puma %d' % (i, i)) for i in range(3)])
log.metadata('rocinante.end', {'reason': 'stopped', 'session_id': 's', 'origin_ns': str(start)}).save('log.mcap')
PYTHON
python3 make.py
try() { "$@" >out 2>&1 && status=0 || status=$?; grep -h format out || true; echo "exit $status"; }
try rocinante log info log.mcap
try rocinante log cat log.mcap
try rocinante log state log.mcap --at 0s
try rocinante log follow --from-start log.mcap
try rocinante log doctor log.mcap
try rocinante play log.mcap --to 127.0.0.1:9 --asap
try rocinante log cut log.mcap -o part.mcap --from 0s
try rocinante log split log.mcap -o pieces/ --time 1s
try rocinante log merge log.mcap log.mcap -o both.mcap
try rocinante log recover log.mcap -o made.mcap
ls
