# A full disk is an error, whatever the form, and leaves nothing.
log="$SRC/examples/demo/session.mcap"
rocinante log table "$log" --device gantry >/dev/full || echo "exit $?"
cp "$log" session.mcap
for ending in csv npy npz; do
  (ulimit -f 10; rocinante log table session.mcap --device gantry -o t.$ending) ||
    echo "exit $?"
done
ls
