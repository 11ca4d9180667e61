# What the player refuses.
. "$SRC/tests/support/blocks.sh"

block "says what it does"
rocinante play --help

block "refuses bad options"
printf 'not a log' >no.mcap
for options in "--speed 0" "--speed 2000" "--speed fast" "--to nowhere" "--asap --speed 2" \
  "--realtime maybe" "--loop -1"; do
  status=0
  # Each option and its value are words of their own.
  rocinante play no.mcap $options 2>said || status=$?
  tail -n 1 said
  echo "$status"
done

block "refuses what is no log"
printf 'not a log' >no.mcap
for log in missing.mcap no.mcap; do
  rocinante play $log --to 127.0.0.1:9 || echo "exit $?"
done

block "an empty log is nothing to play"
rocinante record 127.0.0.1:0 -o empty.mcap --duration 0.05s --quiet
rocinante play empty.mcap --to 127.0.0.1:9 || echo "exit $?"

# Before anything is sent: a report that could not be written would be known only after an hour.
block "asks whether the report can be kept"
cp "$SRC/tests/data/logs/version-1.mcap" session.mcap
mkfifo pipe
try() { rocinante play session.mcap --asap --to 127.0.0.1:9 "$@" || echo "exit $?"; }
try --report no/such/report.json
try --report pipe --force
test -p pipe

# An unreadable log is not reported as empty: the damage is named.
block "says what damage left"
cp "$SRC/tests/data/logs/version-1.mcap" session.mcap
rocinante log cut session.mcap -o holed.mcap --from 0 >/dev/null
printf 'XXXXXXXX' | dd of=holed.mcap bs=1 seek=320 conv=notrunc status=none
{
  rocinante play holed.mcap --asap --to 127.0.0.1:9 || echo "exit $?"
  rocinante log cut holed.mcap -o out.mcap --from 0 || echo "exit $?"
} 2>&1 | sed -e 's/byte[s]* [0-9]*/byte N/' -e 's/\(the chunk\) .*/\1 .../'
ls
