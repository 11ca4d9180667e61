# needs: shared
# Radar on three groups, in fragments: each datagram whole, with where it was sent.
rocinante spy "pcap://$SHARED/captures/navico_br24_radar/BR24.pcap" | sed "s|$SHARED|SHARED|; s/  */ /g" || echo "exit $?"
rocinante spy "pcap://$SHARED/captures/navico_br24_radar/BR24.pcap?filter=dst port 6678" --json |
  grep -E '"(datagrams|bytes|to|incomplete|watched_s)"' || echo "exit $?"
