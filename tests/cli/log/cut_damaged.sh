# What can be read is copied; the damage is named, and the exit code says so.
cp "$SRC/tests/data/logs/version-1.mcap" session.mcap
printf 'X' | dd of=session.mcap bs=1 seek=600 conv=notrunc status=none
status=0
rocinante log cut session.mcap -o out.mcap --from 0.1s || status=$?
echo "exit $status"
rocinante log doctor out.mcap | cut -d'(' -f1
