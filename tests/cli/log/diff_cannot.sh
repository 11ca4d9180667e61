cp "$SRC/tests/data/logs/version-1.mcap" a.mcap
rocinante log diff a.mcap missing.mcap || echo "exit $?"
echo "not a log" > notes.txt
rocinante log diff notes.txt a.mcap || echo "exit $?"
rocinante log diff a.mcap a.mcap --by weather || echo "exit $?"
