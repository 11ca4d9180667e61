# Insets at a real window, by xdotool: dragged into another corner, made larger by the inner corner, swapped with the
# picture by a double click. Evidence then has them there, and a script's commands say the same.
command -v xdotool >/dev/null || { echo "skipped: no xdotool"; exit 77; }
export ASAN_OPTIONS=detect_leaks=0
cat >box.urdf <<'URDF'
<robot name="box"><link name="body"><visual><geometry><box size="1 2 1"/></geometry></visual></link></robot>
URDF
cat >box.cell.toml <<'TOML'
format = 1
[[device]]
name = "box"
model = "box.urdf"
[[camera]]
name = "front"
eye = [0, -6, 0]
target = [0, 0, 0]
[[camera]]
name = "side"
eye = [6, 0, 2]
target = [0, 0, 0]
[[inset]]
camera = "side"
size = [0.4, 0.4]
TOML
cat >person.sh <<'PERSON'
rocinante view box.cell.toml --size 640x480 --detail 0 --samples 1 --style shadows=off --style contact=off --frame-times frames.csv 2>view.txt &
viewer=$!
window=$(xdotool search --sync --onlyvisible --name '^Rocinante')
# What is loaded is shown first.
until grep -qs '^[0-9]*,[0-9]*,[0-9]*,1,1,' frames.csv; do
  kill -0 $viewer || { cat view.txt; exit 1; }
  sleep 0.1
done
drag() {
  xdotool mousemove --window "$window" "$1" "$2" mousedown 1
  xdotool mousemove --window "$window" $((($1 + $3) / 2)) $((($2 + $4) / 2)) mousemove --window "$window" "$3" "$4"
  xdotool mouseup 1
}
xdotool mousemove --window "$window" 320 400 click 1 key --window 0 Tab
# From the top right to the bottom left; then larger, by its corner there.
drag 500 100 100 400
drag 262 282 332 252
xdotool mousemove --window "$window" 100 400 click --repeat 2 1
xdotool key --window 0 s
until ls evidence-*.png >/dev/null 2>&1; do
  kill -0 $viewer || { cat view.txt; exit 1; }
  sleep 0.1
done
xdotool key --window 0 q
wait $viewer
echo "view: exit $?"
PERSON
with_display bash person.sh
rocinante render box.cell.toml --camera side --inset front:bottom-left:0.5x0.45 --size 640x480 --samples 1 -o swapped.png
rocinante golden compare evidence-*.png swapped.png
