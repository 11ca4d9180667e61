# Before anything is sent: a report that could not be written would be known only after an hour.
cp "$SRC/tests/data/logs/version-1.mcap" session.mcap
mkfifo pipe
try() { rocinante play session.mcap --asap --to 127.0.0.1:9 "$@" || echo "exit $?"; }
try --report no/such/report.json
try --report pipe --force
test -p pipe
