# With several logs each message names its log.
cp "$SRC/tests/data/logs/version-1.mcap" a.mcap
cp "$SRC/tests/data/logs/version-1.mcap" b.mcap
rocinante log cat a.mcap b.mcap --channel '*/planner' --format json
