# What was asked for just before the window was closed is made all the same: an evidence picture and a saved session.
command -v xdotool >/dev/null || { echo "skipped: no xdotool"; exit 77; }
export ASAN_OPTIONS=detect_leaks=0 XDG_CACHE_HOME=$PWD/cache
cat >box.urdf <<'URDF'
<robot name="box"><link name="body"><visual><geometry><box size="1 1 1"/></geometry></visual></link></robot>
URDF
port=$((20000 + ($$ + 19) % 20000))
export port
cat >person.sh <<'PERSON'
view() {
  rm -f frames.csv
  rocinante view box.urdf --size 320x240 --detail 0 --samples 1 --fresh --frame-times frames.csv "$@" 2>view.txt &
  viewer=$!
  window=$(xdotool search --sync --onlyvisible --name '^Rocinante')
  until grep -qs '^[0-9]*,[0-9]*,[0-9]*,1,1,' frames.csv; do
    kill -0 $viewer || { cat view.txt; exit 1; }
    sleep 0.05
  done
  xdotool mousemove --window "$window" 300 100
}
# Both keys come in one frame.
press_at_once() {
  kill -STOP $viewer
  xdotool key --window 0 "$1" key --window 0 q
  kill -CONT $viewer
  wait $viewer && echo "$1: exit 0" || { echo "$1: exit $?"; cat view.txt; }
}
view
press_at_once s
ls evidence-*.png
view --live "127.0.0.1:$port"
rocinante source --demo arm --duration 300s --to "127.0.0.1:$port" >/dev/null 2>&1 &
source=$!
until grep -q '"messages": [1-9]' <(rocinante log info cache/rocinante/live/*/live-000001.mcap --json 2>/dev/null); do
  kill -0 $viewer || { cat view.txt; exit 1; }
  sleep 0.05
done
press_at_once shift+s
kill $source
wait $source 2>/dev/null || true
rocinante log doctor live-*.mcap >/dev/null && echo "a sound log"
ls cache/rocinante/live
PERSON
with_display bash person.sh
