# A window without a file waits for one: what is dropped on it, by XDND as a file manager does it, is shown; what cannot
# be shown is named, and the picture stays.
command -v xdotool >/dev/null || { echo "skipped: no xdotool"; exit 77; }
for python in python3 /usr/bin/python3 none; do $python -c "import Xlib" 2>/dev/null && break; done
[ $python != none ] || { echo "skipped: no python3-xlib"; exit 77; }
export python
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
pose = { xyz = [0, 3, 1] }
[[camera]]
name = "front"
eye = [0, -6, 0]
target = [0, 0, 0]
TOML
echo 'no model' >words.urdf
cat >person.sh <<'PERSON'
rocinante view --fresh --size 640x480 --detail 0 --samples 1 2>view.txt &
viewer=$!
window=$(xdotool search --sync --onlyvisible --name '^Rocinante')
drop() { $python "$SRC/tests/cli/view/xdnd_drop.py" "$window" "$@" || { cat view.txt; exit 1; }; }
drop box.urdf
xdotool search --sync --name '^Rocinante: .*box.urdf' >/dev/null
echo "a model is shown"
drop words.urdf
drop two.cell.toml
xdotool search --sync --name '^Rocinante: .*two.cell.toml' >/dev/null
echo "a cell is shown"
# What is being made of this is written before another file is shown.
xdotool key --window 0 Tab key --window 0 s
drop box.urdf
xdotool search --sync --name '^Rocinante: .*box.urdf' >/dev/null
ls evidence-*.png | wc -l
xdotool key --window 0 q
wait $viewer
echo "view: exit $?"
PERSON
with_display bash person.sh
rocinante render two.cell.toml --camera front --size 640x480 --samples 1 --shadows --contact -o there.png
rocinante golden compare evidence-*.png there.png | sed 's/^same:.*/same/'
