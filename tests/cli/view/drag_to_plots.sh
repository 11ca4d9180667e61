# A joint's name and a part of a pose dragged from the device's panel onto the time line at a real window, by xdotool:
# their curves are plotted. One that is dropped elsewhere is not. The table of what is plotted tells which.
command -v xdotool >/dev/null || { echo "skipped: no xdotool"; exit 77; }
export ASAN_OPTIONS=detect_leaks=0
cp "$SRC/examples/demo/session.mcap" .
cat >person.sh <<'PERSON'
rocinante view "$SRC/examples/demo/demo.cell.toml" session.mcap --size 900x600 --detail 9 --samples 1 --frame-times frames.csv 2>view.txt &
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
frames() {
  local until_then=$(($(wc -l <frames.csv) + 30))
  until [ "$(wc -l <frames.csv)" -ge $until_then ]; do
    kill -0 $viewer || { cat view.txt; exit 1; }
    xdotool mousemove --window "$window" 450 300 mousemove --window "$window" 451 301
  done
}
# The arm, whose panel then comes.
xdotool mousemove --window "$window" 628 375 click 1
frames
# joint2, onto the picture; joint1, onto the time line.
drag 704 270 450 300
drag 704 250 450 560
frames
# The canister's x, as packets have said it by then.
for command in "seek 10s" "select canister"; do
  xdotool key --window 0 ctrl+p type --window 0 "$command"
  xdotool key --window 0 Return
  frames
done
drag 701 137 450 560
frames
until ls curves-*.csv >/dev/null 2>&1; do
  kill -0 $viewer || { cat view.txt; exit 1; }
  # "table", above the curves
  xdotool mousemove --window "$window" 795 320 click 1
  sleep 0.1
done
xdotool key --window 0 q
wait $viewer
echo "view: exit $?"
PERSON
with_display bash person.sh
head -2 curves-*.csv
