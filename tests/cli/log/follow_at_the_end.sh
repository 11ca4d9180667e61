# `log follow` of what has ended, or is no log.
. "$SRC/tests/support/blocks.sh"

# A log that is closed already: its messages if requested, and the end.
block "follow closed"
cp "$SRC/tests/data/logs/version-1.mcap" session.mcap
rocinante log follow session.mcap
rocinante log follow session.mcap --from-start --channel '/udp/*/planner' --channel '/rocinante/*'
rocinante log follow session.mcap --from-start --format json >followed.json
rocinante log cat session.mcap --format json >cat.json
cmp followed.json cat.json
rocinante log follow session.mcap --from-start --format csv >followed.csv
rocinante log cat session.mcap --format csv >cat.csv
cmp followed.csv cat.csv

block "follow not a log"
echo "not a log" > notes.txt
rocinante log follow notes.txt || echo "exit $?"
rocinante log follow missing.mcap || echo "exit $?"
rocinante log follow . || echo "exit $?"
