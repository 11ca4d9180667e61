# What goes wrong around a window is a sentence, not a crash: a renderer that is too old, no home to write to, a log that
# is deleted while it is shown, two hundred devices, a window that is made as small as can be and then as large
# as it was, with the same pixels.
command -v xdotool >/dev/null || { echo "skipped: no xdotool"; exit 77; }
command -v xwd >/dev/null || { echo "skipped: no xwd (x11-apps)"; exit 77; }
export ASAN_OPTIONS=detect_leaks=0
cat >box.urdf <<'URDF'
<robot name="box"><link name="body"><visual><geometry><box size="1 1 1"/></geometry></visual></link></robot>
URDF
{
  echo 'format = 1'
  for i in $(seq 200); do
    printf '[[device]]\nname = "box%d"\nmodel = "box.urdf"\npose = { xyz = [%d, %d, 0] }\n' "$i" $((i % 20 * 2)) $((i / 20 * 2))
  done
} >many.cell.toml
cp "$SRC/examples/demo/session.mcap" .
cat >person.sh <<'PERSON'
view() {
  rm -f frames.csv
  rocinante view "$@" --detail 0 --samples 1 --frame-times frames.csv 2>view.txt &
  viewer=$!
  window=$(xdotool search --sync --onlyvisible --name '^Rocinante')
  until grep -qs '^[0-9]*,[0-9]*,[0-9]*,1,1,' frames.csv; do
    kill -0 $viewer || { cat view.txt; exit 1; }
    sleep 0.1
  done
}
# Until that many more frames were shown: events for the mouse make them.
frames() {
  local until_then=$(($(wc -l <frames.csv) + $1))
  until [ "$(wc -l <frames.csv)" -ge $until_then ]; do
    kill -0 $viewer || { cat view.txt; exit 1; }
    xdotool mousemove --window "$window" 100 100 mousemove --window "$window" 101 101
  done
}
quit() {
  xdotool mousemove --window "$window" 100 100 key --window 0 q
  wait $viewer && echo "$1: exit 0" || echo "$1: exit $?"
  cat view.txt
}
LIBGL_ALWAYS_SOFTWARE=1 MESA_GL_VERSION_OVERRIDE=2.1 rocinante view box.urdf 2>&1 | sed 's/OpenGL 3.3: .* (rocinante/OpenGL 3.3: WHY (rocinante/' || echo "too old: exit $?"
(
  unset XDG_CONFIG_HOME XDG_CACHE_HOME
  export HOME=/proc/nowhere
  view box.urdf --size 300x200
  quit "no home"
)
view "$SRC/examples/demo/demo.cell.toml" session.mcap --size 500x400 --fresh
rm session.mcap
# All of the log is read once more.
xdotool mousemove --window "$window" 100 100 key --window 0 Home key --window 0 End key --window 0 space
frames 20
quit "log deleted"
# Recorded, it shows no frame times, which would never be the same again.
view many.cell.toml --size 500x400 --fresh --record-input person.txt
frames 5
shoot() { xwd -silent -id "$window" -out window.xwd && python3 "$SRC/tests/cli/view/xwd_to_png.py" window.xwd "$1"; }
shoot before.png
until shoot again.png && cmp -s before.png again.png; do mv again.png before.png; done
for size in "1 1" "500 1" "1 400" "64 64" "3 7"; do
  shown=$(wc -l <frames.csv)
  xdotool windowsize --sync "$window" $size
  until [ "$(wc -l <frames.csv)" -gt $shown ]; do
    kill -0 $viewer || { cat view.txt; exit 1; }
    sleep 0.05
  done
done
xdotool windowsize --sync "$window" 500 400
for turn in $(seq 300); do
  shoot again.png
  cmp -s before.png again.png && echo "made small: as before" && break
  kill -0 $viewer || { cat view.txt; exit 1; }
  sleep 0.1
done
quit "made small"
PERSON
with_display bash person.sh
