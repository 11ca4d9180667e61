# What exceeds a limit of packet text is in no state: the account says how much, for each source.
zeros=$(printf ' 0%.0s' $(seq 4097))
make_pcap s.pcap \
  '0:whole:RK1 arm@a 0 -\njoints arm 0 0\n' \
  "100:whole:RK1 arm@a 1 -\njoints arm$zeros\njoint arm a=1\n" \
  "200:whole:RK1 other@a 0 -\njoints tray$zeros\njoints arm$zeros\n"
rocinante log import s.pcap -o s.mcap >/dev/null
rocinante log info s.mcap | grep account
