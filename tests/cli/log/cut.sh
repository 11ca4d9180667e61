# What `log cut` makes, of whole and of damaged logs, and what it refuses.
. "$SRC/tests/support/blocks.sh"

# A piece has the messages of its time, the origin of its session, and opens with the state before it.
block "cut time"
cp "$SRC/tests/data/logs/version-1.mcap" session.mcap
rocinante log cut session.mcap -o piece.mcap --from 0.3s --until 0.55s
rocinante log cat piece.mcap
rocinante log cat piece.mcap --channel /rocinante/keyframe | sed 's/  */ /g' | cut -c1-40
rocinante log doctor piece.mcap | cut -d'(' -f1

# From a mark that a person set to the session's own event.
block "cut event"
cp "$SRC/tests/data/logs/version-1.mcap" session.mcap
rocinante log mark session.mcap 0.2s 'look here' > /dev/null
rocinante log cut session.mcap -o piece.mcap --from-event 'look*' --until 0.35s
rocinante log cat piece.mcap --channel '*' --format json | grep -v keyframe | cut -c1-100

# What can be read is copied; the damage is named, and the exit code says so.
block "cut damaged"
cp "$SRC/tests/data/logs/version-1.mcap" session.mcap
printf 'X' | dd of=session.mcap bs=1 seek=600 conv=notrunc status=none
status=0
rocinante log cut session.mcap -o out.mcap --from 0.1s || status=$?
echo "exit $status"
rocinante log doctor out.mcap | cut -d'(' -f1

# A piece that begins after damage begins with a state that may be outdated: this is reported, and so are hidden events.
block "cut behind damage"
python3 "$SRC/tests/cli/spoil_chunks" "$SRC/examples/demo/session.mcap" half.mcap 10 12
shown() { sed 's/checksum ([0-9a-f]*, stored [0-9a-f]*)/checksum/'; }
{ rocinante log cut half.mcap --from 15s --until 16s -o late.mcap 2>&1 || echo "exit $?"; } | shown
rocinante log cut half.mcap --from 5s --until 6s -o early.mcap
{ rocinante log cut half.mcap --from-event picked --until 6s -o picked.mcap 2>&1 || echo "exit $?"; } | shown

# What chooses nothing makes nothing.
block "cut nothing"
cp "$SRC/tests/data/logs/version-1.mcap" session.mcap
for range in '--from 5s' '--from 0.5s --until 0.2s' '--from-event no-such' '--from soon' ''; do
  status=0
  rocinante log cut session.mcap -o out.mcap $range || status=$?
  echo "exit $status"
done
ls

# An existing file, the input itself, and a folder that is not there: nothing is made.
block "cut refused"
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
