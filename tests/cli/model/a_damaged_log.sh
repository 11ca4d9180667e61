# Links of a moment that damage of the log hides: where they stood before, a warning, exit code 1.
cell=$SRC/examples/demo/demo.cell.toml
python3 "$SRC/tests/cli/spoil_chunks" "$SRC/examples/demo/session.mcap" half.mcap 10 99
fk() { local status=0; rocinante model fk "$cell" --device arm --log half.mcap "$@" >out 2>said || status=$?
  sed 's/checksum ([0-9a-f]*, stored [0-9a-f]*)/checksum/' said; echo "exit $status"; }
fk --at 5s
fk --at 15.25s
tail -n 1 out
fk --at 15.25s --json
python3 -c 'import json; a = json.load(open("out")); print(list(a)[:3], len(a["warnings"]))'
fk --at 5s --json
python3 -c 'import json; a = json.load(open("out")); print(list(a)[:3])'
local_status=0; rocinante model convert "$cell" --device arm --log half.mcap --at 15.25s -o arm.obj 2>/dev/null || local_status=$?
echo "convert: exit $local_status"; ls arm.obj 2>/dev/null || true
