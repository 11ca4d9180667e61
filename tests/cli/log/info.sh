# What `log info` says, of whole, killed and damaged logs, and of what is none.
. "$SRC/tests/support/blocks.sh"

# What a log holds, for people.
block "info text"
cp "$SRC/tests/data/logs/version-1.mcap" session.mcap
rocinante log info session.mcap

# The same for scripts.
block "info json"
cp "$SRC/tests/data/logs/version-1.mcap" session.mcap
rocinante log info --json session.mcap

# No line is wider than the terminal, and what is wrong comes first.
block "info on a terminal"
cp "$SRC/tests/data/logs/version-1.mcap" session.mcap
on_terminal 80 rocinante log info session.mcap
echo "== wide"
on_terminal 160 rocinante log info session.mcap
echo "== sound"
cp "$SRC/examples/demo/session.mcap" demo.mcap
on_terminal 80 rocinante log info demo.mcap | sed -n '1,9p'

# Marks beside a log are among its events; a malformed one is reported.
block "info marks"
cp "$SRC/tests/data/logs/version-1.mcap" session.mcap
rocinante log mark session.mcap 0.3s "slipped" > /dev/null
rocinante log info session.mcap | sed -n '/^  events/p;/^  .* s  /p'
rocinante log info --json session.mcap | grep -E '"(events|marks)"'
echo nonsense >> session.mcap.marks
rocinante log info session.mcap || echo "exit $?"

# A log whose recorder was killed is described all the same; the exit code says it is not whole.
block "info killed"
head -c 1200 "$SRC/tests/data/logs/version-1.mcap" > killed.mcap
rocinante log info killed.mcap || echo "exit $?"

# A changed byte is found by the chunk's checksum, and named.
block "info damaged"
cp "$SRC/tests/data/logs/version-1.mcap" damaged.mcap
printf 'X' | dd of=damaged.mcap bs=1 seek=600 conv=notrunc status=none
rocinante log info --json damaged.mcap | sed -n '/"damage"/,$p' || echo "exit $?"
status=0; rocinante log info damaged.mcap > text || status=$?
echo "exit $status"

# What exceeds a limit of packet text is in no state: the account says how much, for each source.
block "info beyond limits"
zeros=$(printf ' 0%.0s' $(seq 4097))
make_pcap s.pcap \
  '0:whole:RK1 arm@a 0 -\njoints arm 0 0\n' \
  "100:whole:RK1 arm@a 1 -\njoints arm$zeros\njoint arm a=1\n" \
  "200:whole:RK1 other@a 0 -\njoints tray$zeros\njoints arm$zeros\n"
rocinante log import s.pcap -o s.mcap >/dev/null
rocinante log info s.mcap | grep account

block "info missing"
rocinante log info nowhere.mcap || echo "exit $?"

# A file that is not a log cannot be described.
block "info not a log"
echo 'not a log' > notes.txt
rocinante log info notes.txt || echo "exit $?"
