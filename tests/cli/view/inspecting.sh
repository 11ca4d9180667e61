# Axes, a distance that was picked by two clicks, and joints that stand elsewhere: the window's picture is that of its
# evidence, which render draws from its own arguments. What cannot be inspected is refused by its line of the script.
export ASAN_OPTIONS=detect_leaks=0
demo=$SRC/examples/demo
cat >script.txt <<'SCRIPT'
seek 7.88s
panels off
measure on
click 154 118
click 197 126
measure off
select arm
key O
reference gantry
packet-behind
frame 2
screenshot window.png
evidence evidence.png
quit
SCRIPT
look() { with_display rocinante view "$demo/demo.cell.toml" "$demo/session.mcap" --camera overview \
  --size 320x240 --profile reproducible --script script.txt 2>&1 || echo "exit $?"; }
look
rocinante golden compare window.png evidence.png
draw() { rocinante render "$demo/demo.cell.toml" --size 64x48 --hash "$@" 2>&1 || echo "exit $?"; }
draw --axes amr
draw --measure arm@0,0
printf 'packet-behind\n' >script.txt
look
