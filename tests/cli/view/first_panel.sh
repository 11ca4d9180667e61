# The first frame says what is being read, before the renderer and the cell are there, however soon the cell is read; the
# next ones show the cell.
command -v xdotool >/dev/null || { echo "skipped: no xdotool"; exit 77; }
export ASAN_OPTIONS=detect_leaks=0
cat >box.urdf <<'URDF'
<robot name="box"><link name="body"><visual><geometry><box size="1 1 1"/></geometry></visual></link></robot>
URDF
cat >person.sh <<'PERSON'
rocinante view box.urdf --size 320x240 --samples 1 --frame-times frames.csv 2>view.txt &
viewer=$!
until grep -qs '^[0-9]*,[0-9]*,[0-9]*,1,1,' frames.csv; do
  kill -0 $viewer || { cat view.txt; exit 1; }
  sleep 0.1
done
window=$(xdotool search --sync --onlyvisible --name '^Rocinante')
xdotool mousemove --window "$window" 100 100 key --window 0 q
wait $viewer && echo "view: exit 0" || echo "view: exit $?"
# Loaded, drawn: of the first frame, and of the first that has the cell.
sed -n 2p frames.csv | cut -d, -f4,5
grep -m 1 '^[0-9]*,[0-9]*,[0-9]*,1,1,' frames.csv | cut -d, -f4,5
PERSON
with_display bash person.sh
