# What `log doctor` says of logs, of copies, and of what is none.
. "$SRC/tests/support/blocks.sh"

# A sound log, one whose recorder was killed, one with a flipped bit, a foreign MCAP file.
block "doctor"
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

# What the tools make keeps every rule, whatever it is made of.
block "doctor of copies"
log=$SRC/tests/data/logs/version-1.mcap
cp "$log" session.mcap
head -c 2000 "$log" > killed.mcap
rocinante log mark session.mcap 0.3s slipped > mark.out
mkdir out
rocinante log cut session.mcap -o out/cut.mcap --from 0.3s --until 0.7s > cut.out
rocinante log filter session.mcap -o out/filter.mcap --source arm > filter.out
rocinante log shift session.mcap -o out/shift.mcap --by 1h > shift.out
rocinante log merge session.mcap out/shift.mcap -o out/merge.mcap > merge.out
rocinante log recover killed.mcap -o out/recover.mcap > recover.out 2>&1 || echo "recover: exit $?"
rocinante log doctor out/*.mcap | sed 's/ (.*//'

# Nothing judged is never yes.
block "doctor cannot"
echo "not a log" > notes.txt
rocinante log doctor notes.txt || echo "exit $?"
rocinante log doctor missing.mcap || echo "exit $?"
: > empty.mcap
rocinante log doctor empty.mcap || echo "exit $?"
