# From a mark that a person set to the session's own event.
cp "$SRC/tests/data/logs/version-1.mcap" session.mcap
rocinante log mark session.mcap 0.2s 'look here' > /dev/null
rocinante log cut session.mcap -o piece.mcap --from-event 'look*' --until 0.35s
rocinante log cat piece.mcap --channel '*' --format json | grep -v keyframe | cut -c1-100
