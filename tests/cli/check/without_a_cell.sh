# A recording alone that carries no cell is judged by what needs none; what was not judged is said.
make_pcap s.pcap \
  '0:whole:RK1 arm@a 0 0\njoints arm 0 0\nsignal arm load 5 kg\nsignal - estop false\n' \
  '100:whole:RK1 arm@a 1 0.1\njoints arm 0.1\nsignal arm load 5 N\npose cart 0 0 0 0 0 0 9\n' \
  '200:whole:RK1 arm@a 5 0.2\njoints arm 99 0\nsignal - estop "yes"\nwobble\n'
check() { rocinante check "$@" && echo fits || echo "exit $?"; }
check s.pcap
check s.pcap --quiet --strict
rocinante log import s.pcap -o s.mcap >/dev/null
rocinante check s.mcap --json | python3 -c '
import json, sys
report = json.load(sys.stdin)
print(report["verdict"], report["cell"], report["session"], report["not_judged"])
print(sorted({finding["rule"] for finding in report["findings"]}))'
rocinante check s.mcap --format junit | grep -c 'nothing to judge: there is no cell'
rocinante check s.mcap --format github | tail -1
rocinante check s.mcap --format sarif | grep -c '"uri": "s.mcap"'
check s.mcap s.mcap --quiet
: >empty.csv
check empty.csv
