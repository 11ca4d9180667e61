# Damage is never silent: what could be read is there, and exit 1 says that it is not all.
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
