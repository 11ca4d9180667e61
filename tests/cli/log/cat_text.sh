# One message a line; other bytes than packet text in hexadecimal.
cp "$SRC/tests/data/logs/version-1.mcap" session.mcap
rocinante log cat session.mcap --from 0.55s --until 0.8s
