# Each datagram waits for its ack; without one the player ends and says so.
: >said
rocinante record 127.0.0.1:0 -o log.mcap >/dev/null 2>said &
recorder=$!
until grep -qs '^recording' said; do sleep 0.02; done
port=$(sed 's/.*:\([0-9]*\) to .*/\1/' said)
printf 't,a\n0,1\n5,2\n9,3\n' >table.csv
rocinante source --csv table.csv --device arm --run r1 --speed 100 --to 127.0.0.1:"$port" --quiet
kill -INT $recorder
wait $recorder

begin() {
  : >said
  rocinante play log.mcap --to 127.0.0.1:"$port" --lockstep --control 127.0.0.1:0 --json "$@" \
    >report 2>said &
  player=$!
  until grep -qs '^playing' said; do sleep 0.02; done
  control=$(sed -n 's/listening for commands on udp:..\(.*\)/\1/p' said)
  exec 3<>"/dev/udp/${control%:*}/${control#*:}"
}
end() {
  status=0
  wait $player || status=$?
  echo "exit $status"
  grep -e '"sent": [0-9]*,$' -e failure report
  sed -e 's/127.0.0.1:[0-9]*/HOST:PORT/' said
}
hear() {
  # One read takes one datagram.
  timeout 10 dd bs=4096 count=1 status=none <&3
}
begin --ack-timeout 30s
printf 'status\n' >&3
hear | sed 's/ sent=.*//'  # the first datagram may have left already
step=$(hear)
while [ "$step" != 'step 4' ]; do
  echo "$step"
  printf 'ack %s\n' "${step#step }" >&3
  step=$(hear)
done
echo "$step"
printf 'ack 4\n' >&3
end

begin --ack-timeout 3s
printf 'status\n' >&3
end

begin --ack-timeout 100ms
end
