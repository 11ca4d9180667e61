# What `log cat` prints: texts, bytes and times, chosen by channel, device and time.
. "$SRC/tests/support/blocks.sh"

# One message a line; other bytes than packet text in hexadecimal.
block "cat text"
cp "$SRC/tests/data/logs/version-1.mcap" session.mcap
rocinante log cat session.mcap --from 0.55s --until 0.8s

# One object per line; a payload that is not packet text is in base64.
block "cat json"
cp "$SRC/tests/data/logs/version-1.mcap" session.mcap
rocinante log cat session.mcap --from 0.6s --until 0.65s --format json

block "cat csv"
cp "$SRC/tests/data/logs/version-1.mcap" session.mcap
rocinante log cat session.mcap --channel '*/planner' --channel '*/127.0.0.1' --format csv

# Packets about one device, and no others.
block "cat device"
cp "$SRC/tests/data/logs/version-1.mcap" session.mcap
rocinante log cat session.mcap --device 'ar*' --until 0.3s
rocinante log cat session.mcap --device tray || echo "exit $?"

# A time with a minus counts from the session's end.
block "cat from end"
cp "$SRC/tests/data/logs/version-1.mcap" session.mcap
rocinante log cat session.mcap --from -0.1s

# With several logs each message names its log.
block "cat several"
cp "$SRC/tests/data/logs/version-1.mcap" a.mcap
cp "$SRC/tests/data/logs/version-1.mcap" b.mcap
rocinante log cat a.mcap b.mcap --channel '*/planner' --format json

# The recorder's own channels are shown when they are asked for.
block "cat own channels"
cp "$SRC/tests/data/logs/version-1.mcap" session.mcap
rocinante log cat session.mcap --channel '/rocinante/*' --format json

# A time outside the log chooses nothing, which is a failure.
block "cat nothing"
cp "$SRC/tests/data/logs/version-1.mcap" session.mcap
rocinante log cat session.mcap --from 5s || echo "exit $?"

block "cat bad time"
cp "$SRC/tests/data/logs/version-1.mcap" session.mcap
rocinante log cat session.mcap --from noon || echo "exit $?"

# A malformed line of LOG.marks is reported with its number when marks are requested.
block "cat marks malformed"
cp "$SRC/tests/data/logs/version-1.mcap" session.mcap
printf '# mine\n12.5 "no calendar time"\n' > session.mcap.marks
rocinante log cat session.mcap | wc -l
rocinante log cat session.mcap --channel '/rocinante/*' || echo "exit $?"
