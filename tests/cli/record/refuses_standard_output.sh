# A log is a file that is read from both ends, so `-` is refused.
rocinante record 127.0.0.1:0 -o - --duration 1ms || echo "exit $?"
rocinante log cut "$SRC/examples/demo/session.mcap" --from 0s -o - || echo "exit $?"
ls
