# One object per line; a payload that is not packet text is in base64.
cp "$SRC/tests/data/logs/version-1.mcap" session.mcap
rocinante log cat session.mcap --from 0.6s --until 0.65s --format json
