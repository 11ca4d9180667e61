# Help, refusals, and what a terminal shows.
. "$SRC/tests/support/blocks.sh"

block "help"
rocinante spy --help | sed -n 1,3p

block "bad endpoint"
rocinante spy nonsense || echo "exit $?"

block "refuses bad options"
try() {
  status=0
  rocinante spy "$@" || status=$?
  echo "$status"
}
try 127.0.0.1:0 --allow 10.0.0.5/8
try 127.0.0.1:0 --allow robot7
try 127.0.0.1:0 --duration 0s
try 'pcap://eth0?ttl=1'
try pcap://./none.pcap
printf 'no capture at all, but long enough' >text.pcap
try pcap://./text.pcap
try pcap://./text.pcap 127.0.0.1:0

# Nothing judged is never yes: exit 2, and the reason why.
block "nothing comes"
rocinante spy 127.0.0.1:0 --duration 2.2s --json 2>/dev/null | sed 's/:[0-9]*"/:PORT"/; s/"watched_s": .*,/"watched_s": 2.2,/; s/127.0.0.1:[0-9]* for [0-9]* s/127.0.0.1:PORT for 2 s/' || echo "exit $?"

# No line is wider than the terminal: names lose their middle, columns their place. Reasons come first.
block "on a terminal"
cp "$SRC/examples/demo/session.mcap" session.mcap
rocinante log export session.mcap --pcap -o session.pcap 2>made.txt >made.txt
on_terminal 80 rocinante spy pcap://./session.pcap
echo "== wide"
on_terminal 160 rocinante spy pcap://./session.pcap
echo "== nothing comes"
{ on_terminal 80 rocinante spy '127.0.0.1:0' --duration 2.1s || echo "exit $?"; } |
  sed -E 's/.*\x1b\[\?1049l//; /^\x1b|\x1b\[K/d; s/:[0-9]+/:PORT/; s/[0-9.]+ s/T s/'
