# tshark agrees with captures, checksums too, and the dissector shows what packets say.
command -v tshark >/dev/null || { echo "skipped: there is no tshark"; exit 77; }
export HOME=$PWD
rocinante log export "$SRC/examples/demo/session.mcap" --pcap -o session.pcap
show() { tshark -r session.pcap "$@" 2>/dev/null; }
show -o ip.check_checksum:TRUE -o udp.check_checksum:TRUE -T fields -e ip.checksum.status -e udp.checksum.status |
  sort | uniq -c | tr -s ' '
show -c 2 -T fields -e frame.time_epoch -e ip.src -e udp.srcport -e ip.dst -e udp.dstport
rocinante log cat "$SRC/examples/demo/session.mcap" --format csv | sed -n '2,3s/,.*//p'
show -X lua_script:"$SRC/share/wireshark/rocinante.lua" -c 3 -T fields -e rocinante.source -e rocinante.run \
  -e rocinante.sequence -e rocinante.kind -e rocinante.device -e rocinante.value
show -X lua_script:"$SRC/share/wireshark/rocinante.lua" -Y rocinante | wc -l
show -X lua_script:"$SRC/share/wireshark/rocinante.lua" -Y 'rocinante.kind == "event"' -T fields -e rocinante.text
show -X lua_script:"$SRC/share/wireshark/rocinante.lua" -Y rocinante.malformed | wc -l
