# The same for scripts.
cp "$SRC/tests/data/logs/version-1.mcap" session.mcap
rocinante log info --json session.mcap
