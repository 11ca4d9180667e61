# A player is stepped through a log by datagrams, and answers each.
: >said
rocinante record 127.0.0.1:0 -o log.mcap >/dev/null 2>said &
recorder=$!
until grep -qs '^recording' said; do sleep 0.02; done
port=$(sed 's/.*:\([0-9]*\) to .*/\1/' said)
printf 't,a\n0,1\n0.1,2\n0.2,3\n' >table.csv
rocinante source --csv table.csv --device arm --run r1 --to 127.0.0.1:"$port" --quiet
kill -INT $recorder
wait $recorder

: >said
rocinante play log.mcap --to 127.0.0.1:"$port" --start-paused --control 127.0.0.1:0 --json \
  >report 2>said &
player=$!
until grep -qs '^playing' said; do sleep 0.02; done
control=$(sed -n 's/listening for commands on udp:..\(.*\)/\1/p' said)
exec 3<>"/dev/udp/${control%:*}/${control#*:}"
ask() {
  printf '%s\n' "$1" >&3
  # One read takes one datagram.
  timeout 10 dd bs=4096 count=1 status=none <&3 | sed 's/ t=[0-9]*[.][0-9]* / t=T /'
}
ask status
ask step
ask 'step 2'
ask 'back 1'
ask 'speed 4'
ask 'seek 0s'
ask 'seek never'
ask 'jump'
ask 'step 1000001'
ask 'loop 5s 6s'
ask next
ask 'step 100'
ask "$(printf 'status\npause\njump')"
ask quit
status=0
wait $player || status=$?
echo "exit $status"
grep -e '"sent": [0-9]*,$' -e interrupted report
sed -e 's/127.0.0.1:[0-9]*/HOST:PORT/' said
