# A signal that changes its unit: its column holds numbers in both, and that is said.
make_pcap s.pcap \
  '0:whole:RK1 arm@a 0 -\njoints arm 0 0\nsignal arm load 5 kg\nsignal arm force 1 N\n' \
  '100:whole:RK1 arm@a 1 -\nsignals arm load=6 force=2\n' \
  '250:whole:RK1 arm@a 2 -\nsignal arm load 49 N\nsignal arm force 3 N\n'
rocinante log import s.pcap -o s.mcap >/dev/null
rocinante log table s.mcap --signals 2>&1 | grep 'left out'
rocinante log table s.mcap 2>&1 | grep -c 'unit' || true
