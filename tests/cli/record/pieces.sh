# Each piece is self-contained, and all of them are the session again; --keep keeps the newest two.
say() {
  printf 'RK1 arm@run %s 5.5\njoints puma %s\n' "$1" "$1" >datagram
  cat datagram >/dev/udp/127.0.0.1/"$port"
  sleep 0.05
}
record() {
  rm -f said
  rocinante record 127.0.0.1:0 "$@" --max-packets 3 >said.out 2>said &
  until grep -qs '^recording' said; do sleep 0.05; done
  port=$(sed -n 's/.*:\([0-9]*\) to .*/\1/p' said)
  say 1
  say 2
  say 3
  wait $!
}
plain() { sed -e "s/:$port to/:PORT to/" -e 's/([^()]* [kM]*B)/(SIZE)/g' -e 's/in [0-9.]* s\(, the first after [0-9.]* s\)\?/in T s/' "$@"; }

record -o 'p-%n.mcap' --split-time 1ms
plain said.out
for piece in p-*.mcap; do rocinante log doctor "$piece" | sed 's/, [0-9]* bytes/, N bytes/'; done
rocinante log merge p-003.mcap p-001.mcap p-002.mcap -o all.mcap | sed 's/, [0-9.]* s/, T s/'
rocinante log cat all.mcap | grep -o 'puma [0-9]'

mkdir two
record -o two/log.mcap --split-time 1ms --keep 2
ls two
plain said.out
grep -c 'is deleted' said
