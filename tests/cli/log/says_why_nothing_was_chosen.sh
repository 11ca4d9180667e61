# Nothing chosen: the sentence says why, where that can be seen.
try() { rocinante log "$@" || echo "exit $?"; }
exec 2>&1
cp "$SRC/tests/data/logs/version-1.mcap" session.mcap
try cat session.mcap --channel arm
try cat session.mcap --from 99s
try cut session.mcap -o out.mcap --from 99s
try filter session.mcap -o out.mcap --channel 'planner*'
rocinante record 127.0.0.1:0 -o empty.mcap --duration 10ms --quiet
try cat empty.mcap
try state empty.mcap --at 1s
