# What a person does with a window, here xdotool, is recorded as a script; another run of the window, which nobody
# touches, does it again and ends in the same picture, panels and all. What was dropped on the window or pasted comes again, too.
command -v xdotool >/dev/null || { echo "skipped: no xdotool"; exit 77; }
for python in python3 /usr/bin/python3 none; do $python -c "import Xlib" 2>/dev/null && break; done
[ $python != none ] || { echo "skipped: no python3-xlib"; exit 77; }
export python
export ASAN_OPTIONS=detect_leaks=0
cp "$SRC/examples/demo/session.mcap" .
cat >arm.urdf <<'URDF'
<robot name="arm">
  <link name="base"><visual><geometry><box size="1 1 0.2"/></geometry></visual></link>
  <link name="boom"><visual><origin xyz="0.5 0 0"/><geometry><box size="1 0.2 0.2"/></geometry></visual></link>
  <joint name="turn" type="revolute"><parent link="base"/><child link="boom"/><axis xyz="0 0 1"/>
    <limit lower="-2" upper="2" effort="1" velocity="1"/></joint>
</robot>
URDF
cat >person.sh <<'PERSON'
rocinante view "$SRC/examples/demo/demo.cell.toml" session.mcap --size 640x480 --samples 1 --profile reproducible \
  --record-input person.txt 2>view.txt &
viewer=$!
window=$(xdotool search --sync --onlyvisible --name '^Rocinante')
to() { xdotool mousemove --window "$window" "$@"; }
# Until the record has that many lines of it.
recorded() {
  until [ "$(grep -c "^$1" person.txt || true)" -ge "$2" ]; do
    kill -0 $viewer || { cat view.txt; exit 1; }
    to 300 100
    to 301 101
  done
}
# Until that many more frames were shown.
frames() { recorded frame-at $(($(grep -c ^frame-at person.txt) + $1)); }
commands=0
command() {
  xdotool key --window 0 ctrl+p type --window 0 "$1"
  xdotool key --window 0 Return
  commands=$((commands + 1))
  recorded "press enter" $commands
  frames 4
}
screenshot() {
  command "screenshot $1.png"
  until [ -s $1.png ]; do
    kill -0 $viewer || { cat view.txt; exit 1; }
    sleep 0.1
  done
}
recorded frame-at 1
# Turn, pan with Shift, zoom; play for a while that nobody knows.
to 320 200
xdotool mousedown 1
to 340 215
to 380 190
xdotool mouseup 1 keydown shift mousedown 1
to 300 180
xdotool mouseup 1 keyup shift click 4 click 4 click 5
xdotool key --window 0 space
frames 20
xdotool key --window 0 space
recorded "press space" 2
frames 4
command "select gantry"
screenshot played
xdotool windowsize "$window" 560 420
recorded window-size 2
frames 4
command "hide layer/labels"
screenshot small
$python "$SRC/tests/cli/view/xdnd_drop.py" "$window" arm.urdf
recorded await-files 1
frames 4
command "joint arm/turn 40deg"
screenshot dropped
# What another program has on the clipboard.
$python "$SRC/tests/cli/view/clipboard.py" "screenshot pasted.png" >clipboard.txt &
clipboard=$!
until grep -qs ready clipboard.txt; do
  kill -0 $clipboard
  sleep 0.1
done
xdotool key --window 0 ctrl+p
recorded "press ctrl+P" $((commands + 1))
frames 4
xdotool key --window 0 ctrl+v
recorded "clipboard screenshot%20pasted.png" 1
frames 4
xdotool key --window 0 Return
until [ -s pasted.png ]; do
  kill -0 $viewer || { cat view.txt; exit 1; }
  sleep 0.1
done
kill $clipboard
xdotool key --window 0 q
wait $viewer
echo "view: exit $?"
cat view.txt
PERSON
with_display bash person.sh
mkdir again
cd again
ln -s ../session.mcap .
with_display rocinante view "$SRC/examples/demo/demo.cell.toml" session.mcap --samples 1 --profile reproducible \
  --script ../person.txt
[ -s pasted.png ] || tail -n 60 ../person.txt
for picture in played small dropped pasted; do rocinante golden compare $picture.png ../$picture.png --tier exact | sed 's/^same:.*/same/'; done

# By hand: a click of the mouse and a key are what `click` and `key` are.
printf 'panels off\nmouse 320 240\nbutton left down\nframe 1\nbutton left up\nframe 1\npress H\nframe 1\nscreenshot mouse.png\n' >mouse.txt
printf 'panels off\nframe 2\nclick 320 240\nkey H\nframe 1\nscreenshot click.png\n' >click.txt
for way in mouse click; do with_display rocinante view ../arm.urdf --size 640x480 --samples 1 --profile reproducible --script $way.txt; done
rocinante golden compare mouse.png click.png --tier exact | sed 's/^same:.*/same/'
