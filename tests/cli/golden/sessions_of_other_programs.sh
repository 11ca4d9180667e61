# Every program that shows or judges a session opens what another program recorded as the log that an import makes.
cat >arm.urdf <<'URDF'
<robot name="arm">
  <link name="base"/> <link name="upper"><visual><geometry><box size="1 0.2 0.2"/></geometry></visual></link>
  <joint name="shoulder" type="revolute"> <parent link="base"/> <child link="upper"/>
    <axis xyz="0 0 1"/> <limit lower="-2" upper="2" effort="1" velocity="9"/> </joint>
</robot>
URDF
table() { awk -v add="$1" 'BEGIN { print "t,shoulder"; for (i = 0; i < 100; i++) print i / 20 "," i / 100 + (i > 50 ? add : 0) }'; }
table 0 >a.csv
table 0.5 >b.csv
for name in a b; do
  rocinante log import $name.csv --cell arm.urdf -o $name.mcap >/dev/null
  rocinante log export $name.mcap arm.urdf --ros2 -o $name.bag.mcap >/dev/null 2>&1 || true
  python3 - $name <<'PY'
# The same as datagrams in a capture file.
import struct, sys
name = sys.argv[1]
out = open(name + '.pcap', 'wb')
out.write(struct.pack('<IHHiIII', 0xa1b2c3d4, 2, 4, 0, 0, 65535, 101))
for i, line in enumerate(open(name + '.csv').read().split()[1:]):
    t, value = line.split(',')
    packet = f'RK1 me@a {i} -\njoint arm shoulder={value}\n'.encode()
    udp = struct.pack('>HHHH', 5000, 19960, 8 + len(packet), 0) + packet
    ip = struct.pack('>BBHHHBBH4s4s', 0x45, 0, 20 + len(udp), i, 0, 64, 17, 0, bytes([10, 0, 0, 1]), bytes([10, 0, 0, 2])) + udp
    ns = int(float(t) * 1e6)
    out.write(struct.pack('<IIII', 1770000000 + ns // 10**6, ns % 10**6, len(ip), len(ip)) + ip)
PY
done
mkdir viewer && echo 'var rocinanteViewer;' >viewer/rocinante-viewer.js && echo wasm >viewer/rocinante-viewer.wasm
cat >served.py <<'PY'
# The log that `serve` gives out.
import os, sys
sys.path.insert(0, os.environ["SRC"] + "/tests/serve")
from serving import Serving
serving = Serving("arm.urdf", sys.argv[1])
open(sys.argv[2], "wb").write(serving.get("/log")[2])
PY
code() { "$@" >out 2>err && echo "$label same, 0" || echo "$label exit $?"; }
for form in mcap csv bag.mcap pcap; do
  for pair in "a a" "a b"; do
    set -- $pair
    x=$1.$form y=$2.$form
    label="$form $1 $2: golden session:" code rocinante golden session $x $y arm.urdf --align origin --no-pictures
    label="$form $1 $2: bisect:" code rocinante golden bisect $x arm.urdf --other-log $y --size 32x32 --samples 1
    label="$form $1 $2: log diff:" code rocinante log diff --by state $x $y
  done
  rocinante log table a.$form --cell arm.urdf 2>/dev/null | tail -n 1
  rocinante log state a.$form --at 4s 2>/dev/null | grep -o 'shoulder=[0-9.]*' | sed -n 1p || echo "state: none"
  rocinante log export a.$form arm.urdf --foxglove -o $form.fox.mcap --force >/dev/null 2>&1 && echo "exported" || echo "export: exit $?"
  # The page and the server carry the log that was made.
  rocinante page arm.urdf a.$form -o $form.html --viewer viewer >/dev/null 2>&1 || echo "page: exit $?"
  rocinante page --extract $form.html -o $form.page.mcap >/dev/null
  python3 served.py a.$form $form.served.mcap 2>/dev/null
  rocinante log table a.$form --cell arm.urdf >table.csv 2>/dev/null || true
  for log in $form.page.mcap $form.served.mcap; do
    (rocinante log table $log --cell arm.urdf 2>/dev/null || true) | cmp - table.csv && echo "${log#$form.} has its values"
  done
  rocinante model fk arm.urdf --log a.$form --at 4s 2>/dev/null | grep upper | sed -n 1p || echo "fk: exit $?"
done
