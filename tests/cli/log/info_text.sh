# What a log holds, for people.
cp "$SRC/tests/data/logs/version-1.mcap" session.mcap
rocinante log info session.mcap
