# A time outside the log chooses nothing, which is a failure.
cp "$SRC/tests/data/logs/version-1.mcap" session.mcap
rocinante log cat session.mcap --from 5s
