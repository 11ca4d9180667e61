# Datagrams that arrive cut are losses to --max-loss: here three of a capture with a short snap length.
# Skipped without libpcap.
grep -q "^  pcap *on" <(rocinante --version --parts 2>/dev/null) || { echo "skipped: no libpcap"; exit 77; }
python3 - <<'PY'
import struct
with open("cut.pcap", "wb") as out:
    out.write(struct.pack("<IHHiIII", 0xA1B2C3D4, 2, 4, 0, 0, 60, 101))  # raw IP
    for i in range(4):
        text = f"RK1 me@a {i} -\njoint arm j={i}\n".encode() + b"# " + b"x" * (60 if i > 0 else 0) + b"\n"
        udp = struct.pack(">HHHH", 1, 19960, 8 + len(text), 0) + text
        ip = struct.pack(">BBHHHBBH4s4s", 0x45, 0, 20 + len(udp), i, 0, 64, 17, 0, b"\x7f\0\0\1", b"\x7f\0\0\1") + udp
        kept = ip[:60] if i > 0 else ip
        out.write(struct.pack("<IIII", 1700000000 + i, 0, len(kept), len(ip)) + kept)
PY
for most in 2 3; do
  rocinante record pcap://./cut.pcap -o most$most.mcap --max-loss $most --json 2>said.txt >summary.json || echo "exit $?"
  grep -v '^recording' said.txt || true
  python3 -c 'import json; s = json.load(open("summary.json")); print(s["packets"], s["losses"])'
done
