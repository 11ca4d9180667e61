# Names and texts of strangers that hold bidi and other unseen characters go to no terminal as they are.
cat > make.py <<'PYTHON'
import os, sys
sys.path.insert(0, os.environ['SRC'] + '/tests/support')
from mcap_file import McapFile
name = 'a\u202eb\u2066c\u200ed\u009be\u061cf\u200bg\ufeffh'
start = 1770000000 * 10**9
arm = (1, '/udp/5000/' + name, 'rk1', {'source': name, 'remote': name})
log = McapFile('rocinante', 'rocinante').session(start)
log.chunk([(arm, start, ('RK1 arm 0 -\njoints puma 1\nevent "%s"\nlabel %s 0 0 0 "%s"' % (name, 'x', name)).encode())])
log.metadata('rocinante.end', {'reason': name, 'session_id': name, 'origin_ns': str(start)})
log.save('log.mcap')
PYTHON
python3 make.py
turned=$(printf 't\342\200\256og.mcap')
cp log.mcap "$turned"
#X 'l\342\200\256og.mcap')"
{
  rocinante log info log.mcap
  rocinante log cat log.mcap
  rocinante log state log.mcap --at 0s
  rocinante log doctor log.mcap || true
  rocinante log diff log.mcap log.mcap
  rocinante log info "$turned" | sed -n 1p
  rocinante log cut "$turned" -o "$(printf 'o\342\200\256ut.mcap')" --from 0s
  rocinante log info "$(printf 'no\342\200\256ne.mcap')" || true
  rocinante log diff --replay log.mcap log.mcap
  rocinante check "$turned" || true
  rocinante play "$turned" --to 127.0.0.1:9 --asap --restate off | tail -n 1
} >said 2>&1
python3 - <<'PYTHON'
text = open('said', encoding='utf-8').read()
unseen = [c for c in text if ord(c) in (0x61C, 0x200B, 0x200E, 0x202E, 0x2066, 0x9B, 0xFEFF)]
print('unseen characters:', len(unseen), 'of', 'said' if text else 'nothing')
PYTHON
grep -E 'complete|^  /udp' said | cut -c1-100
