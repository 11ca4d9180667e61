# --loop A-B, and options that cannot be.
: >said
rocinante record 127.0.0.1:0 -o log.mcap >/dev/null 2>said &
recorder=$!
until grep -qs '^recording' said; do sleep 0.02; done
port=$(sed 's/.*:\([0-9]*\) to .*/\1/' said)
printf 't,a\n0,1\n0.1,2\n0.2,3\n' >table.csv
rocinante source --csv table.csv --device arm --run r1 --to 127.0.0.1:"$port" --quiet
kill -INT $recorder
wait $recorder
for options in "--loop 5s-6s" "--loop 2" "--loop 2s-1s" "--loop x" "--start-paused" "--lockstep" \
  "--gap-limit 0" "--restate 1ms" "--map /udp/1/nobody=:5" "--channel nothing" "--mute *" \
  "--control 239.1.2.3:5" "--control unix:" "--control-allow 10.0.0.0/8" \
  "--control 127.0.0.1:0 --control-allow 10.0.0.0/33" "--map x"; do
  status=0
  set -f
  # Each option and its value are words of their own.
  rocinante play log.mcap --to 127.0.0.1:"$port" --speed 100 --quiet $options 2>said || status=$?
  set +f
  tail -n 1 said
  echo "$options: exit $status"
done
