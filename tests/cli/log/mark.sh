# An event that a person puts beside a log; the log itself is not touched.
cp "$SRC/tests/data/logs/version-1.mcap" session.mcap
rocinante log mark session.mcap 0.5s "the gripper slipped"
rocinante log mark session.mcap -0.1s "$(printf 'two lines\nand \033[2J')"
rocinante log mark session.mcap 2026-02-03T04:05:06.25Z 'sägen'
cmp session.mcap "$SRC/tests/data/logs/version-1.mcap"
cat session.mcap.marks
rocinante log cat session.mcap --channel '/rocinante/mark'
rocinante log cat session.mcap --channel '*' --from 0.45s --until 0.55s --format json
