# Output that cannot be written is a failure.
cp "$SRC/tests/data/logs/version-1.mcap" session.mcap
rocinante log cat session.mcap > /dev/full
