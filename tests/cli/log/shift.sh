# Logs that are moved in time, or filtered.
. "$SRC/tests/support/blocks.sh"

# Every log time moves; times before 1970 are refused.
block "shift"
cp "$SRC/tests/data/logs/version-1.mcap" session.mcap
rocinante log shift session.mcap -o out.mcap --to 2001-02-03T04:05:06Z
rocinante log info --json out.mcap | grep -E '"(origin_ns|start_ns|end_ns)"'
rocinante log cat out.mcap --until 0.1s
status=0
rocinante log shift session.mcap -o old.mcap --to 1969-12-31T23:59:59Z || status=$?
rocinante log shift session.mcap -o old.mcap || status=$?
rocinante log shift session.mcap -o old.mcap --by 1s --to 2001-02-03T04:05:06Z || status=$?
echo "exit $status"
ls

# Keeps whole datagrams with statements about a device; prints the result as JSON.
block "filter device"
cp "$SRC/tests/data/logs/version-1.mcap" session.mcap
rocinante log filter session.mcap -o out.mcap --source planner --json | sed -e '/"bytes"/d'
rocinante log cat out.mcap
status=0
rocinante log filter session.mcap -o none.mcap --device no-such || status=$?
rocinante log filter session.mcap -o none.mcap || status=$?
echo "exit $status"
