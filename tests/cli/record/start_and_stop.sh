# Records from the event that begins a cycle to the one that ends it, with the state before in the opening keyframe.
rocinante record 127.0.0.1:0 -o cycle.mcap --start-on 'event=cycle begins' --stop-on 'event=cycle ends' \
  --stop-on silence=60s >said.out 2>said &
recorder=$!
until grep -qs '^waiting' said; do sleep 0.05; done
port=$(sed -n 's/.*:\([0-9]*\) to .*/\1/p' said)
n=0
for statement in 'joints puma 7' 'event "cycle ends"' 'event "cycle begins"' 'pose puma 1 0 0 0 0 0 1' 'event "cycle ends"' \
  'joints puma 8'; do
  printf 'RK1 arm@run %s -\n%s\n' $n "$statement" >datagram
  cat datagram >/dev/udp/127.0.0.1/"$port" || true
  n=$((n + 1))
done
wait $recorder
sed -e "s/:$port to/:PORT to/" said
sed -e 's/in [0-9.]* s\(, the first after [0-9.]* s\)\?/in T s/' -e 's/([^()]*B)/(SIZE)/' said.out
rocinante log doctor cycle.mcap | sed 's/, [0-9]* bytes/, N bytes/'
rocinante log cat cycle.mcap | grep -c arm
rocinante log state cycle.mcap --at 0s | grep joints
