cp "$SRC/tests/data/logs/version-1.mcap" session.mcap
rocinante log cat session.mcap --from noon
