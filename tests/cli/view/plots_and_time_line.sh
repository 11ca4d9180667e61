# Plots, a table of what they show, and the time line, by a script; the table moves the arm again through `source --csv`.
export ASAN_OPTIONS=detect_leaks=0
demo=$SRC/examples/demo
cp "$demo/session.mcap" session.mcap
cat >plots.script <<'SCRIPT'
plot arm.joint1
plot arm.joint2
plot rate/arm
show-time 7s 7.05s
part 6s 8s
repeat to-and-fro
reverse on
seek 7s
findings on
frame 2
table curves.csv
mark the arm waits
screenshot plots.png
key P
show-time all
key J
frame 2
screenshot line.png
SCRIPT
show() {
  with_display rocinante view "$demo/demo.cell.toml" session.mcap --size 800x500 \
    --samples 1 --profile reproducible --script "$1"
}
show plots.script
head -3 curves.csv
cut -d' ' -f2- session.mcap.marks | tail -1
rocinante golden compare plots.png line.png --quiet >/dev/null || echo "plots are seen"
rocinante source --csv curves.csv --source arm --speed 100 --to 127.0.0.1:19999 --quiet && echo "a table that source reads"
echo 'plot arm.elbow' >wrong.script
show wrong.script || echo "exit $?"
