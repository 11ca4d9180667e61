# Marks beside a log are among its events; a malformed one is reported.
cp "$SRC/tests/data/logs/version-1.mcap" session.mcap
rocinante log mark session.mcap 0.3s "slipped" > /dev/null
rocinante log info session.mcap | sed -n '/^  events/p;/^  .* s  /p'
rocinante log info --json session.mcap | grep -E '"(events|marks)"'
echo nonsense >> session.mcap.marks
rocinante log info session.mcap
