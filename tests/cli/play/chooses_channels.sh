# Channels are chosen, muted and sent elsewhere by their topics.
record() {
  : >said
  rocinante record 127.0.0.1:0 -o "$1" >/dev/null 2>said &
  recorder=$!
  until grep -qs '^recording' said; do sleep 0.02; done
  port=$(sed 's/.*:\([0-9]*\) to .*/\1/' said)
}
stop() {
  kill -INT $recorder
  wait $recorder
}
printf 't,a\n0,1\n0.1,2\n' >table.csv
record first.mcap
for name in left right; do
  rocinante source --csv table.csv --device $name --source $name --run r1 --to 127.0.0.1:"$port" --quiet
done
stop
show() {
  rocinante log cat "$1" --format json | grep -o 'RK1 [a-z]*@r1 [0-9]*' | sort | uniq -c | sed 's/^ *//'
}
for options in "--channel */left" "--mute */left"; do
  record second.mcap
  set -f
  rocinante play first.mcap --speed 10 --to 127.0.0.1:"$port" --quiet $options
  set +f
  stop
  echo "$options"
  show second.mcap
  rm second.mcap
done
record mapped.mcap
rocinante play first.mcap --speed 10 --to 127.0.0.1:9 --map "*/right=127.0.0.1:$port" --quiet
stop
echo mapped
show mapped.mcap
