# Datagrams that a capture has and the log has not make the exit code 1; other protocols do not.
try() { # CAPTURE
  rocinante log import "$1" -o out.mcap --force --json 2>messages.txt >report.json || echo "exit $?"
  grep '"lost"' report.json
  cat messages.txt
}
for how in lost overlap length tcp; do
  make_pcap $how.pcap "0:whole:RK1 me@a 0 0" "10:$how:more than one fragment has"
  echo "# $how"
  try $how.pcap
done
echo "# an interface that is not described"
python3 - <<'PY'
import struct
def block(kind, body):
    body += b"\0" * (-len(body) % 4)
    return struct.pack("<II", kind, 12 + len(body)) + body + struct.pack("<I", 12 + len(body))
frame = open("tcp.pcap", "rb").read()[40:][:62]
def packet(interface):
    return block(6, struct.pack("<IIIII", interface, 0, 1, len(frame), len(frame)) + frame)
head = block(0x0A0D0D0A, struct.pack("<IHHq", 0x1A2B3C4D, 1, 0, -1)) + block(1, struct.pack("<HHI", 1, 0, 0))
open("none.pcapng", "wb").write(head + packet(0) + packet(5))
PY
try none.pcapng
