# Keeps whole datagrams with statements about a device; prints the result as JSON.
cp "$SRC/tests/data/logs/version-1.mcap" session.mcap
rocinante log filter session.mcap -o out.mcap --source planner --json | sed -e '/"bytes"/d'
rocinante log cat out.mcap
status=0
rocinante log filter session.mcap -o none.mcap --device no-such || status=$?
rocinante log filter session.mcap -o none.mcap || status=$?
echo "exit $status"
