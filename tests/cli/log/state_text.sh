# The state at a moment, statement by statement, with owners.
cp "$SRC/tests/data/logs/version-1.mcap" session.mcap
rocinante log state session.mcap --at 0.6
rocinante log state session.mcap --at -0s | sed -n 1,4p
