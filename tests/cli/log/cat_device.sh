# Packets about one device, and no others.
cp "$SRC/tests/data/logs/version-1.mcap" session.mcap
rocinante log cat session.mcap --device 'ar*' --until 0.3s
rocinante log cat session.mcap --device tray || echo "exit $?"
