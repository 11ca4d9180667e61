# A piece opens with a keyframe, and so has the state that the whole has.
cp "$SRC/tests/data/logs/version-1.mcap" session.mcap
rocinante log cut session.mcap -o piece.mcap --from 0.55s >/dev/null
rocinante log info piece.mcap --json | grep -o '"keyframes": *[0-9]*'
rocinante log cat piece.mcap --channel /rocinante/keyframe
for at in 0.6 0.8 -0s; do
  rocinante log state session.mcap --at $at --json | sed 's/"log":"[^"]*"//' >whole
  rocinante log state piece.mcap --at $at --json | sed 's/"log":"[^"]*"//' | cmp - whole && echo "$at: the same"
done
rocinante log cat piece.mcap | wc -l
