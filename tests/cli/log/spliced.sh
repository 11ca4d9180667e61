# Logs that were put together by hand: nothing is passed over without a word.
cat > make.py <<'PYTHON'
import os, sys
sys.path.insert(0, os.environ['SRC'] + '/tests/support')
from mcap_file import McapFile
start = 1770000000 * 10**9
def log(source, begin):
    channel = (1, '/udp/5000/' + source, 'rk1', {'source': source})
    made = McapFile('rocinante', 'rocinante').session(begin)
    for part in range(2):
        made.chunk([(channel, begin + (5 * part + i) * 10**8, b'RK1 %s %d -\njoints %s %d' % (source.encode(), 5 * part + i, source.encode(), i)) for i in range(5)])
    return made.metadata('rocinante.end', {'reason': 'stopped', 'session_id': 's', 'origin_ns': str(begin)})
a, b = log('arm', start), log('gantry', start + 5 * 10**8)
a.save('a.mcap')
b.save('b.mcap')
def behind(made, chunk):
    return made.chunks[chunk][2] + made.chunks[chunk][3] + made.chunks[chunk][5]
open('joined.mcap', 'wb').write(a.bytes + b.bytes)
open('trailing.mcap', 'wb').write(a.bytes + b'remarks')
foreign = b.bytes[b.chunks[0][2]:behind(b, 0)]
open('foreign_chunk.mcap', 'wb').write(a.bytes[:behind(a, 0)] + foreign + a.bytes[behind(a, 0):])
swapped = log('arm', start)
one, two = swapped.chunks
swapped.chunks = [one[:2] + two[2:], two[:2] + one[2:]]
swapped.save('swapped_indexes.mcap')
away = log('arm', start)
away.chunks[1] = away.chunks[1][:2] + (away.chunks[1][2] + 7,) + away.chunks[1][3:]
away.save('index_elsewhere.mcap')
PYTHON
python3 make.py
for log in joined trailing foreign_chunk swapped_indexes index_elsewhere; do
  echo "--- $log"
  rocinante log info $log.mcap >info && status=0 || status=$?
  grep -E '  (messages  |bytes |complete)' info
  echo "exit $status"
  rocinante log recover $log.mcap -o $log-recovered.mcap 2>&1 && status=0 || status=$?
  echo "exit $status"
  rocinante log doctor $log-recovered.mcap | cut -d'(' -f1
done
tail -c +"$(rocinante log info joined.mcap | sed -n 's/.*tail -c +\([0-9]*\).*/\1/p')" joined.mcap | cmp - b.mcap
