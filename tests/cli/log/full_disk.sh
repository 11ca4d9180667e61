# A disk that is full.
. "$SRC/tests/support/blocks.sh"

# A disk that is full ends the work with a sentence and leaves nothing.
block "cut full disk"
cp "$SRC/tests/data/logs/version-1.mcap" session.mcap
status=0
(ulimit -f 1; rocinante log cut session.mcap -o out.mcap --from 0s --compression none) || status=$?
echo "exit $status"
ls

# A full disk is an error, whatever the form, and leaves nothing.
block "table full disk"
log="$SRC/examples/demo/session.mcap"
rocinante log table "$log" --device gantry >/dev/full || echo "exit $?"
cp "$log" session.mcap
for ending in csv npy npz; do
  (ulimit -f 10; rocinante log table session.mcap --device gantry -o t.$ending) ||
    echo "exit $?"
done
ls

# Output that cannot be written is a failure.
block "cat full disk"
cp "$SRC/tests/data/logs/version-1.mcap" session.mcap
rocinante log cat session.mcap > /dev/full || echo "exit $?"
