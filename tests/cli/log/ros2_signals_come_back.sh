# Signals that left as a ROS 2 bag come back by their own names, with their units and every bit.
python3 - <<'PY'
import struct
packets = [(0, 'signal arm load 0.30000000000000004 kg\nsignal arm/tool0 "a b" 1e-12 N'.replace('"a b"', 'a%20b')
               + '\nsignal - estop true\nsignal %2D odd 5e-324\nsignal arm mode "auto \\"x\\""\njoint arm%201 j.1=0.1'),
           (0.5, 'signal arm load 300.5 g\nsignals arm/tool0 a%20b=2\nsignal a%2Fb x 1 V\nsignal a/b x 2'),
           (1, 'signal arm load 0.1 kg\nsignal arm mode "hold"\nsignals - estop=false')]
frames = [struct.pack("<IHHiIII", 0xA1B2C3D4, 2, 4, 0, 0, 65535, 101)]
for i, (time, text) in enumerate(packets):
    text = f"RK1 me@a {i} -\n{text}\n".encode()
    udp = struct.pack(">HHHH", 5000, 19960, 8 + len(text), 0) + text
    ip = struct.pack(">BBHHHBBH4s4s", 0x45, 0, 20 + len(udp), i, 0, 64, 17, 0, b"\n\0\0\1", b"\n\0\0\2") + udp
    frames.append(struct.pack("<IIII", 1770000000 + int(time), round(time % 1 * 1e6), len(ip), len(ip)) + ip)
open("said.pcap", "wb").write(b"".join(frames))
PY
rocinante record pcap://./said.pcap -o said.mcap --quiet
rocinante log export said.mcap --ros2 -o bag.mcap >/dev/null 2>left_out.txt || echo "exit $?"
rocinante log import bag.mcap -o back.mcap >/dev/null
for log in said back; do
  for at in 0 0.5 1; do rocinante log state $log.mcap --at ${at}s --json >$log.$at.json; done
done
python3 - <<'PY'
import json
def signals(log, at):
    document = json.load(open(f"{log}.{at}.json"))
    all = {("", None, each["name"]): (each["value"], each["unit"]) for each in document["signals"]}
    for device in document["devices"]:
        for each in device["signals"]:
            all[device["name"], each["link"], each["name"]] = (each["value"], each["unit"])
    return all
for at in ("0", "0.5", "1"):
    said, back = signals("said", at), signals("back", at)
    print(at, "s:", len(said), "signals", "the same" if said == back else f"{said} != {back}")
joints = [each["name"] for each in json.load(open("back.0.json"))["devices"] if each["named_joints"]]
print("joints of", joints)
PY
