# Chunks that claim hundreds of megabytes out of a few kilobytes are expanded within a budget; the rest is reported.
cat > make.py <<'PYTHON'
import os, sys
sys.path.insert(0, os.environ['SRC'] + '/tests/support')
from mcap_file import McapFile
channel = (1, '/bomb', 'octets', {})
for name, summary in [('indexed', True), ('walked', False)]:
    log = McapFile()
    for i in range(40):
        log.bomb(channel, i, 100 * 10**6)
    log.chunk([(channel, 40, b'after them')])
    log.save(name + '.mcap', summary)
PYTHON
python3 make.py
for log in indexed walked; do
  rocinante log info --json $log.mcap >info.json && status=0 || status=$?
  grep -E '^  "messages"' info.json
  grep -c 'is not expanded' info.json
  echo "exit $status"
  rocinante log doctor $log.mcap >report && status=0 || status=$?
  grep -c chunk-unread report
  echo "exit $status"
  rocinante log cat $log.mcap --from 0.00000004s 2>/dev/null || echo "exit $?"
done
