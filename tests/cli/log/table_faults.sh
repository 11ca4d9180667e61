# Units that change, and a clock that was set: what a table says.
. "$SRC/tests/support/blocks.sh"

# A signal that changes its unit: its column holds numbers in both, and that is said.
block "table units"
make_pcap s.pcap \
  '0:whole:RK1 arm@a 0 -\njoints arm 0 0\nsignal arm load 5 kg\nsignal arm force 1 N\n' \
  '100:whole:RK1 arm@a 1 -\nsignals arm load=6 force=2\n' \
  '250:whole:RK1 arm@a 2 -\nsignal arm load 49 N\nsignal arm force 3 N\n'
rocinante log import s.pcap -o s.mcap >/dev/null
rocinante log table s.mcap --signals 2>&1 | grep 'left out'
rocinante log table s.mcap 2>&1 | grep -c 'unit' || true

# A signal that is in its unit from before the first row on, and changes it in the table; a packet
# that comes late changes nothing.
block "table units held"
make_pcap s.pcap \
  '0:whole:RK1 arm@a 0 -\njoints arm 0 0\n' \
  '1000:whole:RK1 arm@a 1 -\nsignal arm load 5 N\n' \
  '12000:whole:RK1 arm@a 3 -\nsignal arm load 5 kN\n' \
  '13000:whole:RK1 arm@a 2 -\nsignal arm load 5 kg\n' \
  '14000:whole:RK1 arm@a 4 -\njoints arm 1 0\n'
rocinante log import s.pcap -o s.mcap >/dev/null
rocinante log table s.mcap --signals --from 10s --every 1s
rocinante log table s.mcap --signals --from 12s 2>&1 | grep -c unit || true

# A clock that was set while it recorded: 53.9 years. A row for each second of them is nobody's wish.
block "every of a set clock"
printf 't,arm.j\n5,0.1\n6,0.2\n1700000000,0.3\n' >set.csv
rocinante log import set.csv -o set.mcap | sed 's/ [0-9.]* s;/ N s;/'
rocinante log table set.mcap --every 1s -o set-table.csv || echo "exit $?"
echo '<robot name="r"><link name="a"/></robot>' >arm.urdf
rocinante log export arm.urdf set.mcap --gltf --every 1s -o set.glb || echo "exit $?"
rocinante log table set.mcap --every 1s --until 7s
ls
