# What is no log, what chooses nothing, what cannot be decoded, and what was not all read.
. "$SRC/tests/support/blocks.sh"

# A file of another known kind is refused by the name of its kind.
block "names what is no log"
(
try() { rocinante log "$@" || echo "exit $?"; }
exec 2>&1
printf '\xd4\xc3\xb2\xa1\x02\x00\x04\x00' >cell.pcap
printf '\x0a\x0d\x0d\x0a\x1c\x00\x00\x00' >cell.pcapng
gzip -c "$SRC/tests/data/logs/version-1.mcap" >session.mcap.gz
printf '#ROSBAG V2.0\n' >session.bag
printf 'SQLite format 3\0' >session.db3
for file in cell.pcap cell.pcapng session.mcap.gz session.bag session.db3; do try info "$file"; done
try doctor cell.pcap
rocinante record cell.pcap || echo "exit $?"
)

# Nothing chosen: the sentence says why, where that can be seen.
block "says why nothing was chosen"
(
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
)

# A declaration's fault has its place; a log of which nothing is decoded is a no.
block "decode refusals"
cp "$SRC/tests/data/logs/version-1.mcap" session.mcap
printf '[[decoder]]\nname = "arm"\nkind = "struct"\n[[decoder.field]]\nname = "q"\nat = 0\ntype = "f32"\n[[decoder.joint]]\ndevice = "arm"\njoint = "j"\nfield = "p"\n' >arm.decoders.toml
rocinante log decode session.mcap --decoders arm.decoders.toml -o out.mcap || echo $?
rocinante log decode session.mcap --decoders none.toml -o out.mcap || echo $?
sed -i 's/"p"/"q"/; s/kind/bytes = 77777\nkind/' arm.decoders.toml
rocinante log decode session.mcap --decoders arm.decoders.toml -o out.mcap || echo $?
rocinante log decode session.mcap --decoders arm.decoders.toml -o session.mcap || echo $?

# Damage is never silent: what could be read is there, and exit 1 says that it is not all.
block "export damaged"
cp "$SRC/examples/demo/session.mcap" session.mcap
size=$(stat -c %s session.mcap)
printf 'spoilt' | dd of=session.mcap bs=1 seek=$((size / 2)) conv=notrunc status=none
rocinante log table session.mcap --device gantry -o t.csv || echo "exit $?"
rocinante log export session.mcap "$SRC/examples/demo/demo.cell.toml" --foxglove -o f.mcap --json >report ||
  echo "exit $?"
sed -n '/"gaps"/,$p' report
rocinante log export session.mcap --pcap -o s.pcap || echo "exit $?"
head -c 20000 "$SRC/examples/demo/session.mcap" >killed.mcap
rocinante log export killed.mcap --pcap -o k.pcap || echo "exit $?"
