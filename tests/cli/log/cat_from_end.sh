# A time with a minus counts from the session's end.
cp "$SRC/tests/data/logs/version-1.mcap" session.mcap
rocinante log cat session.mcap --from -0.1s
