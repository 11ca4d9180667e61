# What `log diff` finds, and what it cannot compare.
. "$SRC/tests/support/blocks.sh"

# Compares a log with itself without its second half, moved in time, and unchanged.
block "diff"
log=$SRC/tests/data/logs/version-1.mcap
cp "$log" a.mcap
rocinante log diff a.mcap a.mcap
rocinante log filter a.mcap -o without.mcap --not-channel '/udp/*/planner' > /dev/null
rocinante log diff a.mcap without.mcap || echo "exit $?"
rocinante log shift a.mcap -o later.mcap --by 250ms > /dev/null
rocinante log diff a.mcap later.mcap || echo "exit $?"
rocinante log diff a.mcap later.mcap --by payload
rocinante log diff a.mcap later.mcap --by state --json || echo "exit $?"
rocinante log diff without.mcap a.mcap --by time --json || echo "exit $?"

block "diff cannot"
cp "$SRC/tests/data/logs/version-1.mcap" a.mcap
rocinante log diff a.mcap missing.mcap || echo "exit $?"
echo "not a log" > notes.txt
rocinante log diff notes.txt a.mcap || echo "exit $?"
rocinante log diff a.mcap a.mcap --by weather || echo "exit $?"
