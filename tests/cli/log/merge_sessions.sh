# Two sessions make a new one; the name of it follows from theirs.
cp "$SRC/tests/data/logs/version-1.mcap" session.mcap
rocinante log shift session.mcap -o later.mcap --by +0.5s
rocinante log merge session.mcap later.mcap -o both.mcap --json | grep -E '"(messages|repeated|channels|origin_ns)"'
rocinante log doctor both.mcap | cut -d'(' -f1
