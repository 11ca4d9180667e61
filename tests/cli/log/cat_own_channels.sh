# The recorder's own channels are shown when they are asked for.
cp "$SRC/tests/data/logs/version-1.mcap" session.mcap
rocinante log cat session.mcap --channel '/rocinante/*' --format json
