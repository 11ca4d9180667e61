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
# Programs that only show or judge what is in it cannot forget the warning: the reader gives it.
cat >arm.urdf <<'URDF'
<robot name="arm"><link name="base"/><link name="hand"><visual><geometry><box size="1 1 1"/></geometry></visual></link>
<joint name="turn" type="continuous"><parent link="base"/><child link="hand"/></joint></robot>
URDF
cat >cell.toml <<'TOML'
format = 1
[[device]]
name = "puma"
model = "arm.urdf"
TOML
cat >suite.toml <<'TOML'
format = 1
cell = "cell.toml"
log = "log.mcap"
[[case]]
name = "begin"
at = "0s"
size = [16, 16]
samples = 1
TOML
export ROCINANTE_USER=ada
short() { "$@" >out 2>&1 && status=0 || status=$?; echo "$2 $3: $(grep -c 'format "9"' out) exit $status"; }
short rocinante render cell.toml log.mcap --at 0s --size 16x16 -o picture.png
short rocinante model fk cell.toml --device puma --log log.mcap --at 0s
short rocinante check cell.toml log.mcap
short rocinante golden approve suite.toml -m first
short rocinante golden run suite.toml
short rocinante golden session log.mcap log.mcap cell.toml --align origin --no-pictures
short rocinante golden bisect log.mcap cell.toml --other-log log.mcap --size 16x16
short rocinante log extract log.mcap --list
short rocinante log table log.mcap --cell cell.toml
short rocinante log diff log.mcap log.mcap
short rocinante log export log.mcap cell.toml --foxglove -o fox.mcap
