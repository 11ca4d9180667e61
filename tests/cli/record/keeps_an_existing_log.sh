echo precious >log.mcap
rocinante record 127.0.0.1:0 -o log.mcap --duration 0.05s --quiet || echo "exit $?"
cat log.mcap
rocinante record 127.0.0.1:0 -o log.mcap --duration 0.05s --quiet --force
head -c 5 log.mcap | tail -c 4
