# Writes a capture of twenty seconds and a half of one joint, twenty packets a second: at 2 s it is at 2.5 for
# one second, from 5 s to 20 s its source is silent.
# usage: joint_capture.py FILE
import struct
import sys

with open(sys.argv[1], "wb") as file:
    file.write(struct.pack("<IHHiIII", 0xa1b2c3d4, 2, 4, 0, 0, 65535, 101))
    for i in range(1, 400):
        ms = i * 50 if i < 100 else i * 50 + 15000
        value = 2.5 if 2000 <= ms < 3000 else 1
        words = " restated" if i % 40 == 0 else ""
        text = f"RK1 me@a {i} {1770091506 + ms / 1000:.3f}{words}\norder arm turn\njoints arm {value}\n".encode()
        udp = struct.pack(">HHHH", 5000, 19960, 8 + len(text), 0) + text
        ip = struct.pack(">BBHHHBBH4s4s", 0x45, 0, 20 + len(udp), 0, 0, 64, 17, 0, bytes([10, 0, 0, 1]), bytes([10, 0, 0, 2]))
        sum = 0
        for at in range(0, 20, 2):
            sum += ip[at] << 8 | ip[at + 1]
        sum = (sum & 0xffff) + (sum >> 16)
        ip = ip[:10] + struct.pack(">H", ~((sum & 0xffff) + (sum >> 16)) & 0xffff) + ip[12:]
        file.write(struct.pack("<IIII", 1770091506 + ms // 1000, ms % 1000 * 1000, len(ip + udp), len(ip + udp)) + ip + udp)
