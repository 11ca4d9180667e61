# Recovers the readable part of a log that ends inside a chunk, and names the rest.
head -c 1200 "$SRC/tests/data/logs/version-1.mcap" > killed.mcap
status=0
rocinante log recover killed.mcap -o whole.mcap --json | sed '/"bytes"/d' || status=$?
rocinante log recover killed.mcap -o again.mcap || status=$?
echo "exit $status"
rocinante log doctor whole.mcap | cut -d'(' -f1
