# The state at a moment.
. "$SRC/tests/support/blocks.sh"

# The state at a moment, statement by statement, with owners.
block "state text"
cp "$SRC/tests/data/logs/version-1.mcap" session.mcap
rocinante log state session.mcap --at 0.6
rocinante log state session.mcap --at -0s | sed -n 1,4p

# The same for scripts: one object.
block "state json"
cp "$SRC/tests/data/logs/version-1.mcap" session.mcap
rocinante log state session.mcap --at 0.6 --json

# A piece opens with a keyframe, and so has the state that the whole has.
block "state keyframe"
cp "$SRC/tests/data/logs/version-1.mcap" session.mcap
rocinante log cut session.mcap -o piece.mcap --from 0.55s >/dev/null
rocinante log info piece.mcap --json | grep -o '"keyframes": *[0-9]*'
rocinante log cat piece.mcap --channel /rocinante/keyframe
for at in 0.6 0.8 -0s; do
  rocinante log state session.mcap --at $at --json | sed 's/"log":"[^"]*"//' >whole
  rocinante log state piece.mcap --at $at --json | sed 's/"log":"[^"]*"//' | cmp - whole && echo "$at: the same"
done
rocinante log cat piece.mcap | wc -l

# A moment outside the log is refused, and nothing is printed.
block "state outside"
cp "$SRC/tests/data/logs/version-1.mcap" session.mcap
rocinante log state session.mcap --at 9 || echo "exit $?"
rocinante log state session.mcap --at noon || echo "exit $?"
rocinante log state missing.mcap --at 0 || echo "exit $?"
