# Pieces by time, and the session again out of them, whatever their order.
cp "$SRC/tests/data/logs/version-1.mcap" session.mcap
rocinante log split session.mcap -o pieces-%n.mcap --time 0.25s
for piece in pieces-*.mcap; do rocinante log doctor $piece | cut -d'(' -f1; done
rocinante log merge pieces-003.mcap pieces-001.mcap pieces-004.mcap pieces-002.mcap -o again.mcap
for log in session.mcap again.mcap; do
  rocinante log info --json $log | grep -E '"(content_sha256|session_id|origin_ns)"'
done
rocinante log split session.mcap -o folder --event '*' --json | grep -E '"(output|messages)"'
rocinante log split session.mcap -o x.mcap --size 100
