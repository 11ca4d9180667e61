# Shift+G: a case is added to a suite of this cell and log. Another session's moment, or another cell's, would be drawn of the
# suite's files, and is refused.
export ASAN_OPTIONS=detect_leaks=0
demo=$SRC/examples/demo
cp "$demo/session.mcap" "$demo/motion.mcap" .
printf 'camera overview\nseek picked\ngolden-case\nquit\n' >first.txt
printf 'camera overview\nseek 2s\ngolden-case second\nquit\n' >second.txt
view() { with_display rocinante view "$@" --fresh --size 320x240 --samples 1 2>&1 || echo "exit $?"; }
view "$demo/demo.cell.toml" session.mcap --script first.txt
view session.mcap "$demo/demo.cell.toml" --script second.txt
view "$demo/demo.cell.toml" motion.mcap --script second.txt
view "$demo/arm.urdf" session.mcap --script second.txt
printf 'golden-case at-rest\nquit\n' >rest.txt
view "$demo/demo.cell.toml" --script rest.txt
grep -c '^\[\[case\]\]' view.suite.toml
sed -n 's/^name = //p; s/^at = //p' view.suite.toml
