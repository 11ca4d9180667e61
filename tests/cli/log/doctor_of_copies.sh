# What the tools make keeps every rule, whatever it is made of.
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
