# With the right button held W flies: through the diagonal of a cube of a metre in six seconds, the same way again from
# the same script; Q does not close the window then. Dragging that button alone pans, and Q alone closes it.
export ASAN_OPTIONS=detect_leaks=0
cat >box.urdf <<'URDF'
<robot name="box"><link name="body"><visual><geometry><box size="1 1 1"/></geometry></visual></link></robot>
URDF
cat >start.toml <<'TOML'
format = 1
[[device]]
name = "box"
model = "box.urdf"
[[camera]]
name = "front"
eye = [0, -6, 0]
target = [0, 0, 0]
TOML
cat >flies.txt <<'SCRIPT'
panels off
mouse 200 150
button right down
frame 1
hold W
frame 60
release W
frame 1
save-camera forward
hold E
hold shift
wheel -1
frame 15
release E
release shift
mouse 200 50
frame 1
save-camera up
button right up
frame 1
save-camera ended
quit
SCRIPT
cat >drags.txt <<'SCRIPT'
panels off
mouse 200 150
button right down
frame 1
mouse 240 140
frame 1
button right up
frame 1
save-camera dragged
camera front
pan 40 -10
save-camera panned
quit
SCRIPT
runs() {
  cp start.toml "$1.cell.toml"
  with_display rocinante view "$1.cell.toml" --size 400x300 --samples 1 --script "$2"
}
# NAME: where its eye is, in millimetres.
eye() {
  sed -n "/^name = \"$2\"/{n;s/eye = \[\(.*\)\]/\1/p}" "$1.cell.toml" | awk -F', ' '{printf "%s:", name
    for (i = 1; i <= 3; i++) printf " %d", $i * 1000 + ($i < 0 ? -0.5 : 0.5); print ""}' name="$2"
}
runs once flies.txt
for name in forward up ended; do eye once $name; done
runs again flies.txt
cmp once.cell.toml again.cell.toml && echo "the same again"
sed 's/^release W/press Q\nframe 3\n&/' flies.txt >presses.txt
runs presses presses.txt
grep -c '"ended"' presses.cell.toml
runs drags drags.txt
diff <(grep -A2 '"dragged"' drags.cell.toml | tail -2) <(grep -A2 '"panned"' drags.cell.toml | tail -2) && echo "a drag pans"
printf 'panels off\nmouse 200 150\npress Q\nframe 3\nsave-camera late\n' >alone.txt
runs alone alone.txt
grep -c '"late"' alone.cell.toml || true
