# A table with 100 signals is imported, written by `log table --signals`, imported again and sent by
# `source --csv`: the same numbers to the last bit.
awk 'BEGIN {
  srand(7)
  line = "t,arm.j1"
  for (i = 0; i < 90; ++i) line = line ",signal arm" (i % 3 ? "" : "/tip") " s" i
  for (i = 0; i < 10; ++i) line = line ",signal - n" i
  print line
  for (row = 0; row < 40; ++row) {
    line = row / 10 "," row / 8
    for (i = 0; i < 100; ++i) line = line sprintf(",%.17g", (rand() - 0.5) * exp((rand() - 0.5) * 600))
    print line
  }
}' >first.csv
rocinante log import first.csv -o first.mcap >/dev/null
rocinante log table first.mcap --signals -o table.csv >/dev/null
head -1 table.csv | tr , '\n' | wc -l
rocinante log import table.csv -o second.mcap >/dev/null
rocinante log table second.mcap --signals -o again.csv >/dev/null
cmp table.csv again.csv && echo "imported: the same"

# The last row without its time.
last() { sed -n '$p' "$1" | cut -d, -f2-; }
: >said
rocinante record 127.0.0.1:0 -o sent.mcap >/dev/null 2>said &
recorder=$!
until grep -qs '^recording' said; do sleep 0.02; done
port=$(sed 's/.*:\([0-9]*\) to .*/\1/' said)
rocinante source --csv table.csv --run r1 --speed 10 --restate 0 --to 127.0.0.1:"$port" --quiet
kill -INT $recorder
wait $recorder
rocinante log table sent.mcap --signals -o sent.csv >/dev/null
head -1 table.csv >header
head -1 sent.csv | cmp - header
last table.csv >wanted
last sent.csv | cmp - wanted && echo "sent: the same"
# Every value of every row came, not only the last.
tail -n +2 table.csv | cut -d, -f3- | tr , '\n' | sort -u >wanted
tail -n +2 sent.csv | cut -d, -f3- | tr , '\n' | sed '/^$/d' | sort -u >came
comm -23 wanted came | wc -l

# Booleans and texts of other tables, and what is no joint of the cell.
printf 'format = 1\n[[device]]\nname = "arm"\nmodel = "arm.urdf"\n' >cell.toml
printf '<robot name="arm"><link name="base"/><link name="tip"/><joint name="j1" type="continuous"><parent link="base"/><child link="tip"/></joint></robot>' >arm.urdf
printf 't,arm.j1,arm.current,signal - estop,mode,clearance/a/b,signal arm x%%zz\n0,0.5,1e-12,true,auto,1,2\n1,0.6,2e-12,False,,1,2\n' >other.csv
rocinante log import other.csv --cell cell.toml -o other.mcap >/dev/null
rocinante log cat other.mcap --channel '/rocinante/decoded/**' --format json | sed -n 's/.*"text": *"\(RK1.*\)"[^"]*$/\1/p'
rocinante log info other.mcap | grep account
