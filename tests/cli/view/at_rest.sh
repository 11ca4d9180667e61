# A window whose machine cannot hold the frame rate draws less while the log plays; at rest it shows everything, pixel
# for pixel, and then spends next to nothing.
command -v xdotool >/dev/null || { echo "skipped: no xdotool"; exit 77; }
command -v xwd >/dev/null || { echo "skipped: no xwd (x11-apps)"; exit 77; }
export ASAN_OPTIONS=detect_leaks=0
demo=$SRC/examples/demo
printf 'panels off\nplay\nwait 2\nframe 2\nscreenshot whole.png\nquit\n' >script.txt
cat >person.sh <<'PERSON'
view() { rocinante view "$demo/demo.cell.toml" "$demo/session.mcap" --size 640x400 "$@"; }
# Until the end of the log, for nothing may move later.
view --at -0.5s --detail 0 --style shadows --style contact --script script.txt
view --at -0.5s --target-fps 240 --frame-times frames.csv 2>view.txt &
viewer=$!
window=$(xdotool search --sync --onlyvisible --name '^Rocinante')
xdotool key --window 0 space
for turn in $(seq 300); do
  # The panels tell what is drawn; without them the picture alone is left. It shows the end when playing is over.
  [ $turn = 10 ] && xdotool key --window 0 Tab
  xwd -silent -id "$window" -out window.xwd && python3 "$SRC/tests/cli/view/xwd_to_png.py" window.xwd window.png
  rocinante golden compare window.png whole.png --tier exact --quiet >compared.txt 2>&1 && break
  kill -0 $viewer || { cat view.txt; exit 1; }
  sleep 0.2
done
sed 's/^same:.*/at rest: everything/' compared.txt
ticks() { awk '{print $14 + $15}' /proc/$viewer/stat; }
sleep 2
before=$(ticks)
sleep 3
spent=$(($(ticks) - before))
[ $spent -le 30 ] && echo "at rest: idle" || echo "at rest: $spent of 300 ticks"
xdotool key --window 0 q
wait $viewer
echo "view: exit $?"
head -n 1 frames.csv
# Every line has all fields; some frames drew the scene, the last one shows the whole picture.
awk -F, 'NR > 1 { if (NF != 11) bad = 1; if ($5 == 1) ++drawn; whole = $7 }
  END { print bad || !drawn ? "frames: wrong" : "frames: written", "whole:", whole }' frames.csv
PERSON
export demo
with_display bash person.sh
