# Marks beside a log.
. "$SRC/tests/support/blocks.sh"

# An event that a person puts beside a log; the log itself is not touched.
block "mark"
cp "$SRC/tests/data/logs/version-1.mcap" session.mcap
rocinante log mark session.mcap 0.5s "the gripper slipped"
rocinante log mark session.mcap -0.1s "$(printf 'two lines\nand \033[2J')"
rocinante log mark session.mcap 2026-02-03T04:05:06.25Z 'sägen'
cmp session.mcap "$SRC/tests/data/logs/version-1.mcap"
cat session.mcap.marks
rocinante log cat session.mcap --channel '/rocinante/mark'
rocinante log cat session.mcap --channel '*' --from 0.45s --until 0.55s --format json

# A moment outside the log is none.
block "mark outside"
cp "$SRC/tests/data/logs/version-1.mcap" session.mcap
rocinante log mark session.mcap 99s late || echo "exit $?"
rocinante log mark session.mcap soon late || echo "exit $?"
rocinante log mark session.mcap 0.5s "" || echo "exit $?"
rocinante log mark missing.mcap 0.5s x || echo "exit $?"
ls
