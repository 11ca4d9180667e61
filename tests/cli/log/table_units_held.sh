# A signal that is in its unit from before the first row on, and changes it in the table; a packet
# that comes late changes nothing.
make_pcap s.pcap \
  '0:whole:RK1 arm@a 0 -\njoints arm 0 0\n' \
  '1000:whole:RK1 arm@a 1 -\nsignal arm load 5 N\n' \
  '12000:whole:RK1 arm@a 3 -\nsignal arm load 5 kN\n' \
  '13000:whole:RK1 arm@a 2 -\nsignal arm load 5 kg\n' \
  '14000:whole:RK1 arm@a 4 -\njoints arm 1 0\n'
rocinante log import s.pcap -o s.mcap >/dev/null
rocinante log table s.mcap --signals --from 10s --every 1s
rocinante log table s.mcap --signals --from 12s 2>&1 | grep -c unit || true
