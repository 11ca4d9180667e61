# An existing file, the input itself, and a folder that is not there: nothing is made.
cp "$SRC/tests/data/logs/version-1.mcap" session.mcap
echo mine > there.mcap
for output in there.mcap session.mcap ./session.mcap nowhere/out.mcap /dev/null; do
  status=0
  rocinante log cut session.mcap -o "$output" --from 0.1s || status=$?
  echo "exit $status"
done
cat there.mcap
cmp session.mcap "$SRC/tests/data/logs/version-1.mcap"
ls
rocinante log cut session.mcap -o there.mcap --from 0.5s --force
