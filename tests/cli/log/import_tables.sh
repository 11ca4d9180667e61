# Tables, JSON lines and LCM logs become logs, told by their content; the numbers come back exact.
printf 't,arm.j1,arm.j2,tray:x,tray:y,tray:z,tray:qx,tray:qy,tray:qz,tray:qw,remark\n' >wide.dat
printf '0.5,0.1,-1.25,1,2,3,0,0,0,1,begins\n0.500000001,0.30000000000000004,,,,,,,,,\n' >>wide.dat
printf 'time_ns,device,joint,value\n1700000000123456789,arm,j1,0.5\n1700000000123456790,arm,j2,7\n' >long.dat
printf '{"t": 1.5, "arm": {"j1": 0.5}}\n{"t": 2, "device": "arm", "name": ["j1"], "position": [1]}\n' >lines.dat
python3 - <<'PY'
import struct
def event(number, time_us, channel, data):
    return struct.pack(">IQqii", 0xEDA1DA01, number, time_us, len(channel), len(data)) + channel + data
whole = event(0, 1700000000000001, b"POSE", b"\1\2") + event(1, 1700000000000002, b"ARM", b"RK1 arm 1 0\njoint arm j1=0.5\n")
open("events.dat", "wb").write(whole)
open("torn.dat", "wb").write(whole[:-5] + whole)
PY
for kind in wide long lines events torn; do
  rocinante log import $kind.dat -o $kind.mcap || echo "exit $?"
  rocinante log doctor $kind.mcap | sed "s/, [0-9]* bytes)/)/"
done
rocinante log cat wide.mcap --channel '/rocinante/decoded/*'
rocinante log table wide.mcap
rocinante log cat long.mcap --channel '/rocinante/decoded/*'
# Names without a device are joints of --device; what does not fit is kept and counted.
printf 't,j1,j2\n1,2,3\n2,x,3\n3,4\nsoon,1,1\n' >plain.dat
rocinante log import plain.dat -o plain.mcap --device arm || echo "exit $?"
rocinante log cat plain.mcap --channel '/rocinante/decoded/*'
# Several recordings become one session.
rocinante log import wide.dat lines.dat -o both.mcap
