# The same for scripts: one object.
cp "$SRC/tests/data/logs/version-1.mcap" session.mcap
rocinante log state session.mcap --at 0.6 --json
