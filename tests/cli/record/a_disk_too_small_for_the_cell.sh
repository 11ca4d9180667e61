# A log that cannot hold its cell is none: nothing of it stays, and nothing was recorded.
(ulimit -f 400 && rocinante record 127.0.0.1:0 --cell "$SRC/examples/demo/demo.cell.toml" -o session.mcap \
  --duration 50ms) || echo "exit $?"
ls
