# Nothing is written until an event triggers the ring; then the log opens with the state before it.
rocinante record 127.0.0.1:0 -o 'crash-%n.mcap' --ring 30s --ring-on 'event=*collision*' >said.out 2>said &
recorder=$!
until grep -qs '^recording' said; do sleep 0.05; done
port=$(sed -n 's/.*:\([0-9]*\) into .*/\1/p' said)
say() {
  printf '%b' "$1" >datagram
  cat datagram >/dev/udp/127.0.0.1/"$port"
}
say 'RK1 arm@run 0 -\nadd puma puma\n'
say 'RK1 arm@run 1 -\njoints puma 1 2\nevent "no harm"\n'
ls
say 'RK1 arm@run 2 -\njoints puma 1 3\nevent "a collision of puma"\n'
until grep -qs 'is written' said; do sleep 0.05; done
say 'RK1 arm@run 3 -\njoints puma 1 4\n'
kill -INT $recorder
wait $recorder
sed -e "s/:$port into/:PORT into/" -e 's/: [0-9.]* s to/: T s to/' -e 's/([^()]*B)/(SIZE)/' said
sed -e 's/in [0-9.]* s\(, the first after [0-9.]* s\)\?/in T s/' -e 's/([^()]*B)/(SIZE)/' said.out
rocinante log doctor crash-001.mcap | sed 's/, [0-9]* bytes/, N bytes/'
rocinante log info crash-001.mcap --json | grep '^  "messages"'
