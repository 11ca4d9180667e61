"""A swing of one joint as other programs record it."""
import struct
import subprocess

import rocinante

FORMS = ["csv", "bag.mcap", "pcap"]
ARM = """<robot name="arm"><link name="base"/><link name="upper"/>
<joint name="shoulder" type="revolute"><parent link="base"/><child link="upper"/>
<axis xyz="0 0 1"/><limit lower="-2" upper="2" effort="1" velocity="9"/></joint></robot>"""


def capture(path, packets):
    """A capture of (seconds, packet text), one datagram each."""
    frames = [struct.pack("<IHHiIII", 0xA1B2C3D4, 2, 4, 0, 0, 65535, 101)]
    for i, (time, text) in enumerate(packets):
        udp = struct.pack(">HHHH", 5000, 19960, 8 + len(text), 0) + text.encode()
        ip = struct.pack(">BBHHHBBH4s4s", 0x45, 0, 20 + len(udp), i, 0, 64, 17, 0, b"\n\0\0\1", b"\n\0\0\2") + udp
        frames.append(struct.pack("<IIII", 1770000000 + int(time), round(time % 1 * 1e6), len(ip), len(ip)) + ip)
    path.write_bytes(b"".join(frames))


def foreign(folder, form, name="swing", add=0.0):
    """The model, and a recording of 100 values: a table, a ROS 2 bag or a capture of datagrams."""
    arm, log = folder / "arm.urdf", folder / f"{name}.{form}"
    arm.write_text(ARM)
    values = [(i / 20, i / 100 + (add if i > 50 else 0)) for i in range(100)]
    if form == "pcap":
        capture(log, [(time, f"RK1 me@a {i} -\njoint arm shoulder={value!r}\n")
                      for i, (time, value) in enumerate(values)])
        return arm, log
    table = folder / f"{name}.csv"
    table.write_text("t,shoulder\n" + "".join(f"{time!r},{value!r}\n" for time, value in values))
    if form == "bag.mcap":
        session = folder / f"{name}.session.mcap"
        for words in (["import", table, "--cell", arm, "-o", session, "--force"],
                      ["export", session, arm, "--ros2", "-o", log, "--force"]):
            subprocess.run([rocinante.program(), "log", *words], capture_output=True, check=False)
        assert log.exists()
    return arm, log
