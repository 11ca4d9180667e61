# Pieces of a session, and sessions as one.
. "$SRC/tests/support/blocks.sh"

# Pieces by time, and the session again out of them, whatever their order.
block "split and merge"
cp "$SRC/tests/data/logs/version-1.mcap" session.mcap
rocinante log split session.mcap -o pieces-%n.mcap --time 0.25s
for piece in pieces-*.mcap; do rocinante log doctor $piece | cut -d'(' -f1; done
rocinante log merge pieces-003.mcap pieces-001.mcap pieces-004.mcap pieces-002.mcap -o again.mcap
for log in session.mcap again.mcap; do
  rocinante log info --json $log | grep -E '"(content_sha256|session_id|origin_ns)"'
done
rocinante log split session.mcap -o folder --event '*' --json | grep -E '"(output|messages)"'
rocinante log split session.mcap -o x.mcap --size 100 || echo "exit $?"

# Two sessions make a new one; the name of it follows from theirs.
block "merge sessions"
cp "$SRC/tests/data/logs/version-1.mcap" session.mcap
rocinante log shift session.mcap -o later.mcap --by +0.5s
rocinante log merge session.mcap later.mcap -o both.mcap --json | grep -E '"(messages|repeated|channels|origin_ns)"'
rocinante log doctor both.mcap | cut -d'(' -f1
