# What is typed while the window is busy is not lost, nor is it taken for commands: here it stands still from before
# Ctrl+P, and M, until after Enter, so that all of it comes in one frame.
command -v xdotool >/dev/null || { echo "skipped: no xdotool"; exit 77; }
export ASAN_OPTIONS=detect_leaks=0
cat >box.urdf <<'URDF'
<robot name="box"><link name="body"><visual><geometry><box size="1 1 1"/></geometry></visual></link></robot>
URDF
cp "$SRC/examples/demo/session.mcap" s.mcap
cat >person.sh <<'PERSON'
rocinante view box.urdf s.mcap --size 640x480 --detail 0 --samples 1 2>view.txt &
viewer=$!
window=$(xdotool search --sync --onlyvisible --name '^Rocinante')
xdotool mousemove --window "$window" 320 240
kill -STOP $viewer
xdotool key --window 0 ctrl+p type --window 0 'screenshot typed.png'
xdotool key --window 0 Return
kill -CONT $viewer
until [ -e typed.png ]; do
  kill -0 $viewer || { cat view.txt; exit 1; }
  sleep 0.1
done
kill -STOP $viewer
xdotool key --window 0 m type --window 0 'hello there'
xdotool key --window 0 Return
kill -CONT $viewer
until [ -e s.mcap.marks ]; do
  kill -0 $viewer || { cat view.txt; exit 1; }
  sleep 0.1
done
cut -d ' ' -f 2- s.mcap.marks
xdotool key --window 0 q
wait $viewer
echo "view: exit $?"
PERSON
with_display bash person.sh
