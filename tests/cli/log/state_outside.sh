# A moment outside the log is refused, and nothing is printed.
cp "$SRC/tests/data/logs/version-1.mcap" session.mcap
rocinante log state session.mcap --at 9 || echo "exit $?"
rocinante log state session.mcap --at noon || echo "exit $?"
rocinante log state missing.mcap --at 0 || echo "exit $?"
