# Shift+G says on what terms the picture is made: scale, moved and hidden insets are in the case, and nothing of the session
# beside, whose ghosts are clear. The golden of the case is the evidence of the window without that session.
export ASAN_OPTIONS=detect_leaks=0
cp -r "$SRC/examples/demo" demo && cd demo
printf '\n[[inset]]\ncamera = "map"\n' >>demo.cell.toml
cat >script.txt <<'SCRIPT'
panels off
seek 2s
golden-case whole
inset 1 bottom-left
golden-case moved
insets off
golden-case none
beside off
evidence evidence.png
quit
SCRIPT
with_display rocinante view demo.cell.toml session.mcap --camera overview --size 320x240 --scale 1.5 \
  --profile reproducible --beside session.mcap --align 1.5s --script script.txt 2>&1 || echo "exit $?"
grep -v '^\(cell\|log\)' view.suite.toml
rocinante golden approve view.suite.toml -m first >/dev/null
rocinante golden run view.suite.toml | sed 's/: .*//'
rocinante golden compare evidence.png "$(find . -path '*golden*' -name 'none*.png')"
