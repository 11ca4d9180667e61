# A time outside the log chooses nothing, and that is no success.
cp "$SRC/tests/data/logs/version-1.mcap" session.mcap
rocinante log cat session.mcap --from 5s
