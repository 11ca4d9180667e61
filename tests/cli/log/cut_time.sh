# A piece has the messages of its time, the origin of its session, and opens with the state before it.
cp "$SRC/tests/data/logs/version-1.mcap" session.mcap
rocinante log cut session.mcap -o piece.mcap --from 0.3s --until 0.55s
rocinante log cat piece.mcap
rocinante log cat piece.mcap --channel /rocinante/keyframe | sed 's/  */ /g' | cut -c1-40
rocinante log doctor piece.mcap | cut -d'(' -f1
