cp "$SRC/tests/data/logs/version-1.mcap" session.mcap
rocinante log cat session.mcap --channel '*/planner' --channel '*/127.0.0.1' --format csv
