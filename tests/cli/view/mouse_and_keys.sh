# A person at a real window, by xdotool: a click is taken where it was though the pointer jumps onto a panel at once;
# Esc closes an open list and leaves the selection; H then hides what was clicked, which an evidence picture shows.
command -v xdotool >/dev/null || { echo "skipped: no xdotool"; exit 77; }
export ASAN_OPTIONS=detect_leaks=0
cat >box.urdf <<'URDF'
<robot name="box"><link name="body"><visual><geometry><box size="1 1 1"/></geometry></visual></link></robot>
URDF
cat >two.cell.toml <<'TOML'
format = 1
[[device]]
name = "near"
model = "box.urdf"
[[device]]
name = "far"
model = "box.urdf"
pose = { xyz = [0, 3, 0] }
[[camera]]
name = "front"
eye = [0, -6, 0]
target = [0, 0, 0]
TOML
cat >person.sh <<'PERSON'
rocinante view two.cell.toml --size 640x480 --detail 0 --samples 1 2>view.txt &
viewer=$!
window=$(xdotool search --sync --onlyvisible --name '^Rocinante')
# The picture's middle, then the list of cameras.
xdotool mousemove --window "$window" 470 240 click 1 mousemove --window "$window" 140 48 click 1
xdotool key --window 0 Escape key --window 0 h key --window 0 Tab key --window 0 s
until ls evidence-*.png >/dev/null 2>&1; do
  kill -0 $viewer || { cat view.txt; exit 1; }
  sleep 0.1
done
xdotool key --window 0 q
wait $viewer
echo "view: exit $?"
PERSON
with_display bash person.sh
# Shadows and contact are the looks of a window that nobody gave any.
rocinante render two.cell.toml --camera front --size 640x480 --samples 1 --hide near --shadows --contact -o hidden.png
rocinante golden compare evidence-*.png hidden.png
