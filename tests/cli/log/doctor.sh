# A sound log, one whose recorder was killed, one with a flipped bit, a foreign MCAP file.
log=$SRC/tests/data/logs/version-1.mcap
cp "$log" session.mcap
rocinante log doctor session.mcap
head -c 2000 "$log" > killed.mcap
rocinante log doctor killed.mcap || echo "exit $?"
cp "$log" flipped.mcap
printf '\x55' | dd of=flipped.mcap bs=1 seek=700 conv=notrunc status=none
rocinante log doctor --json flipped.mcap > report || echo "exit $?"
sed 's/\(does not decompress\): [^"]*/\1/' report
rocinante log doctor --json session.mcap killed.mcap || echo "exit $?"
