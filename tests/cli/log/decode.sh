# Packets of a KUKA telegram lie behind their datagrams, which stay as they were; decoding again
# changes nothing, and a filter by device keeps pairs.
telegram() {
  printf '<Rob Type="KUKA"><RIst X="445.0" Y="0.0" Z="790.0" A="90.0" B="0.0" C="0.0"/><AIPos A1="%s" A2="-90.0" A3="90.0" A4="0.0" A5="45.0" A6="180.0"/><Delay D="%s"/></Rob>' "$1" "$2"
}
rocinante record 127.0.0.1:0 -o raw.mcap --max-packets 4 >/dev/null 2>said &
recorder=$!
until grep -qs '^recording' said; do sleep 0.05; done
port=$(sed 's/.*:\([0-9]*\) to .*/\1/' said)
exec 3>/dev/udp/127.0.0.1/"$port"
telegram 0 0 >&3
telegram 10 0 >&3
telegram 20 2 >&3
printf '<Rob>cut' >&3
wait $recorder
rocinante log decode raw.mcap --decoders "$SRC/examples/decoders/kuka_rsi.decoders.toml" -o decoded.mcap | sed 1d
rocinante log info decoded.mcap | sed -n 's/^  messages/messages/p; s/^  attached/attached/p; s/^  events  /events/p'
rocinante log doctor decoded.mcap >/dev/null && echo sound
for log in raw decoded; do rocinante log info $log.mcap --json | grep content_sha256; done | uniq | wc -l
rocinante log decode decoded.mcap --decoders "$SRC/examples/decoders/kuka_rsi.decoders.toml" -o again.mcap >/dev/null
for log in decoded again; do rocinante log info $log.mcap --json | grep decoded_sha256; done | uniq | wc -l
rocinante log filter again.mcap --device kr10 -o arm.mcap | sed 's/,.*//'
rocinante log state arm.mcap --at=-0s | grep -o 'joint_a1[ =]*[0-9.]*'
