# The examples of docs/sending.md in C and Python: each sends to the receiver in Python and to a recorder, and restates.
# The C++ one needs an installed library: tests/consumer/library/run.
command -v cc >/dev/null || { echo "skipped: there is no C compiler"; exit 77; }
examples=$SRC/examples/sending
cc -std=c99 -Wall -Wextra -pedantic -Werror "-I$SRC/core/source" "$examples/sender.c" -o sender
ports() { sed -n "s/^$1.*[ :]\([0-9][0-9]*\)\( to .*\)\?$/\1/p" "$2"; }
for example in ./sender "python3 $examples/sender.py"; do
  python3 "$examples/receiver.py" 127.0.0.1 0 190 >received &
  receiver=$!
  rm -f log.mcap; : >said
  rocinante record 127.0.0.1:0 -o log.mcap >/dev/null 2>said &
  recorder=$!
  until grep -qs '^listening' received && grep -qs '^recording' said; do sleep 0.02; done
  $example 127.0.0.1 "$(ports listening received)" 200
  $example 127.0.0.1 "$(ports recording said)" 230
  wait $receiver
  kill -INT $recorder
  wait $recorder
  sed -n '2p;$p' received
  rocinante log cat log.mcap --format json | sed -n 's/.*"text": *"RK1 sim@[0-9a-f]* \(0\|229\) [0-9.]*\(.*\)".*/\2/p'
  rocinante log cat log.mcap --format json | grep -c 'restated part=r1:1/1\\norder arm shoulder elbow\\njoints arm ' >/dev/null && echo restated
  rocinante log state log.mcap --at 1s | grep -c arm >/dev/null && echo "one state"
done
# The page says how long the examples are.
wc -l "$examples"/* | awk '$1 > 40 && $2 != "total" { print "too long: " $2 }'
