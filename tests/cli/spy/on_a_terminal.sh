# No line is wider than the terminal: names lose their middle, columns their place. Reasons come first.
cp "$SRC/examples/demo/session.mcap" session.mcap
rocinante log export session.mcap --pcap -o session.pcap 2>made.txt >made.txt
on_terminal 80 rocinante spy pcap://./session.pcap
echo "== wide"
on_terminal 160 rocinante spy pcap://./session.pcap
echo "== nothing comes"
{ on_terminal 80 rocinante spy '127.0.0.1:0' --duration 2.1s || echo "exit $?"; } |
  sed -E 's/.*\x1b\[\?1049l//; /^\x1b|\x1b\[K/d; s/:[0-9]+/:PORT/; s/[0-9.]+ s/T s/'
