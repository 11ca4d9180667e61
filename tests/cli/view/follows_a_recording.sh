# A log that is being written is followed from piece to piece: the window opens at its end and continues with it.
export ASAN_OPTIONS=detect_leaks=0
demo=$SRC/examples/demo
port=$((20000 + ($$ + 7) % 20000))
rocinante record "127.0.0.1:$port" -o piece.mcap --split-time 1s --quiet >/dev/null 2>&1 &
record=$!
rocinante source --demo all --duration 300s --to "127.0.0.1:$port" >/dev/null 2>&1 &
source=$!
until [ -s piece-001.mcap ] && grep -q '"messages": [1-9]' <(rocinante log info piece-001.mcap --json 2>/dev/null); do sleep 0.05; done
cat >script.txt <<'SCRIPT'
await 2.5s
pause
seek 0.5s
panels off
frame 2
screenshot past.png
now
frame 2
quit
SCRIPT
with_display rocinante view "$demo/demo.cell.toml" piece-001.mcap --size 320x240 \
  --profile reproducible --script script.txt && echo followed
kill $source
kill -INT $record
wait $record $source 2>/dev/null
rocinante render "$demo/demo.cell.toml" piece-001.mcap --at 0.5s --size 320x240 -o first.png
rocinante golden compare past.png first.png
