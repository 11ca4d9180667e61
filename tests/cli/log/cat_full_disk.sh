# Output that cannot be written is no success.
cp "$SRC/tests/data/logs/version-1.mcap" session.mcap
rocinante log cat session.mcap > /dev/full
