# Signals: what a capture says beside joints is in the state, the table, copies and comparisons.
make_pcap s.pcap \
  '0:whole:RK1 arm@a 0 -\njoints arm 0 0\nsignal arm load 5 kg\nsignal arm mode "auto"\nsignal - estop false\n' \
  '100:whole:RK1 arm@a 1 -\njoints arm 0.1 0\nsignals arm load=5.5\nsignals arm/tip force=2e1\n' \
  '200:whole:RK1 arm@a 2 -\nsignal arm mode "fault"\nsignals - estop=true\n' \
  '300:whole:RK1 arm@a 3 -\njoints arm 0.2 0\nsignal arm load default\n'
rocinante log import s.pcap -o s.mcap
rocinante log state s.mcap --at -0s
rocinante log state s.mcap --at 0.15 --json | python3 -c '
import json, sys
state = json.load(sys.stdin)
for device in [*state["devices"], state]:
    for each in device["signals"]:
        print(each)'
rocinante log table s.mcap --signals
rocinante log table s.mcap --signals --device arm -o s.npz
python3 -c '
import zipfile
print(zipfile.ZipFile("s.npz").namelist())'
rocinante log table s.mcap >/dev/null
rocinante log cat s.mcap --until 0.2s --device arm
rocinante log cut s.mcap --from 0.15s -o later.mcap
rocinante log state later.mcap --at 0.2 | grep signal
{ rocinante log diff s.mcap later.mcap || true; } | grep -c signal
