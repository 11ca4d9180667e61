# How a recording ends, and what that says.
. "$SRC/tests/support/blocks.sh"

# A recording of nothing says so and exits with 0; --min-packets is the gate.
block "hears nothing"
plain() { sed -e 's/\(127.0.0.1\|::1\]\):[0-9]*/\1:PORT/g' -e 's/([0-9.]* k*B)/(SIZE)/'; }
rocinante record 127.0.0.1:0 '[::1]:0' -o a.mcap --duration 50ms 2>/dev/null | sed 's/in [0-9.]* s/in T s/' | plain
rocinante record 127.0.0.1:0 -o b.mcap --duration 50ms --json 2>/dev/null | grep -E '"(packets|first_after_s|subscription)"' | sort -u
rocinante record 127.0.0.1:0 -o c.mcap --duration 50ms --quiet
rocinante record 127.0.0.1:0 -o d.mcap --duration 50ms --min-packets 1 2>&1 >/dev/null | grep -v '^recording' || echo "exit $?"

block "fewer than min packets is no"
rocinante record 127.0.0.1:0 -o log.mcap --duration 0.05s --min-packets 1 --quiet || echo "exit $?"

# timeout(1) hands its signal to the recorder and to its group, so twice: the log is closed whole all the same.
block "interrupted twice"
timeout -s INT 60 rocinante record 127.0.0.1:0 -o log.mcap >/dev/null 2>said &
until grep -qs '^recording' said; do kill -0 $!; sleep 0.02; done
kill -INT $!
wait $! && echo "exit 0"
rocinante log info log.mcap | grep complete

# A folder takes the default name, a pattern is filled in.
block "names the log"
mkdir logs
rocinante record 127.0.0.1:0 -o logs --duration 0.02s --quiet
ls logs | sed 's/[0-9]/9/g'
rocinante record 127.0.0.1:0 -o 'cell-%F.mcap' --duration 0.02s --quiet
ls cell-* | sed 's/[0-9]/9/g'
rocinante record 127.0.0.1:0 --duration 0.02s 2>/dev/null | sed -e 's/[0-9]/9/g' -e 's/9* B/9 B/' -e 's/:9* (/:PORT (/'

# Closed standard streams, a full disk behind them, a reader that has left: the recorder's messages are
# lost, and never written into the log; the recording continues to its end.
block "goes on when nobody listens"
mkfifo left
exec 3<>left 4>left 3<&-  # a pipe whose reader has gone
for said in '>&-' '2>&-' '>&- 2>&-' '<&- >&- 2>&-' '>/dev/full 2>&1' '>&4 2>&4'; do
  rm -f session.mcap
  eval "rocinante record 127.0.0.1:0 -o session.mcap --status 10ms --duration 100ms $said" >/dev/null 2>&1 || echo "exit $?"
  echo "$said: $(rocinante log doctor session.mcap | grep -o "sound\|breach"), $(rocinante log info session.mcap | grep complete)"
done
