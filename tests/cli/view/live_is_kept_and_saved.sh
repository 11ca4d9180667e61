# A live window under a script: the past is shown while the session continues, drawn as evidence and saved as an ordinary
# log with its cell; what is saved shows the same.
export ASAN_OPTIONS=detect_leaks=0 XDG_CACHE_HOME=$PWD/cache
demo=$SRC/examples/demo
port=$((20000 + $$ % 20000))
rocinante source --demo all --duration 300s --to "127.0.0.1:$port" >/dev/null 2>&1 &
source=$!
cat >script.txt <<'SCRIPT'
await 1.5s
pause
seek 1s
await-line an earlier moment, not now
panels off
frame 2
screenshot past.png
evidence evidence.png
now
frame 2
seek 1s
pause
save saved.mcap
await-line saved: saved.mcap (
dismiss
frame 2
screenshot again.png
quit
SCRIPT
with_display rocinante view "$demo/demo.cell.toml" --live "127.0.0.1:$port" --size 320x240 \
  --profile reproducible --script script.txt
kill $source
wait $source 2>/dev/null
rocinante golden compare past.png evidence.png
rocinante golden compare past.png again.png
rocinante render saved.mcap --at 1s --size 320x240 -o saved.png
rocinante golden compare past.png saved.png
rocinante log doctor saved.mcap >/dev/null && echo sound
ls cache/rocinante/live
