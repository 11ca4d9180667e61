# The window's own picture, judged against the committed goldens: equal pixels, or on another Mesa within
# rounding. What a window of a person writes into a suite as its looks are the looks of that suite.
rocinante golden run "$SRC/tests/golden/window/window.suite.toml" | sed -E 's/^(same +[a-z-]+): .*/\1/'
grep -q '^ *window' <(rocinante --version --parts) || { echo "skipped: no window in this build"; exit 77; }
cat >person.txt <<'SCRIPT'
camera overview
frame-at 0.1
golden-case carried window.toml
frame-at 0.2
quit
SCRIPT
cp "$SRC/examples/demo/session.mcap" .
with_display rocinante view "$SRC/examples/demo/demo.cell.toml" session.mcap --size 640x360 --fresh --script person.txt
grep '^style' window.toml
grep -m 1 '^style' "$SRC/tests/golden/window/window.suite.toml"
