# What the window shows, of a free camera and with looks, render draws from its own arguments: the same bytes.
export ASAN_OPTIONS=detect_leaks=0
cat >script.txt <<'SCRIPT'
seek 7.88s
orbit 60 -20
panels off
key E
select gantry
frame 2
screenshot window.png
evidence evidence.png
quit
SCRIPT
with_display rocinante view "$SRC/examples/demo/demo.cell.toml" \
  "$SRC/examples/demo/session.mcap" --size 320x240 --profile reproducible --script script.txt
rocinante golden compare window.png evidence.png
