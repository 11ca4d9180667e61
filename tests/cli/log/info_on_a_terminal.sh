# No line is wider than the terminal, and what is wrong comes first.
cp "$SRC/tests/data/logs/version-1.mcap" session.mcap
on_terminal 80 rocinante log info session.mcap
echo "== wide"
on_terminal 160 rocinante log info session.mcap
echo "== sound"
cp "$SRC/examples/demo/session.mcap" demo.mcap
on_terminal 80 rocinante log info demo.mcap | sed -n '1,9p'
