# Of a capture file, --trust keeps what is signed, once and in time, and counts the rest by reason;
# spy and check say the same, and `log verify` finds it in a log that has everything.
cat >trusted.toml <<'END'
[[key]]
public = "A6EHv/POEL4dcN0Y50vAmWfk1jCbpQ1fHdyGZBJVMbg="
sources = ["arm"]
END
cat >arm.urdf <<'END'
<robot name="arm"><link name="base"/><link name="tip"/><link name="end"/>
<joint name="a" type="continuous"><parent link="base"/><child link="tip"/></joint>
<joint name="b" type="continuous"><parent link="tip"/><child link="end"/></joint></robot>
END
python3 - <<'END'
import struct

ARM, STRANGER = '9d24e2eeaf27c2a0', '4d4dbe917544b079'


def packet(source, sequence, joint, key, signature):
    at = f'1700000000{sequence}00000000'
    text = f'RK1 {source}@r {sequence} 1700000000.{sequence} at={at}\njoints {source} {joint} -0.785\n'
    return text.encode(), f'sig {key} {signature}==\n'.encode()


# Signed by OpenSSL (docs/signing.md).
good0 = packet('arm', 0, 0.1, ARM, 'D2T/dx6qe5vvqrpnjcE40MzAGXKXnL9Jk2SO/7I0gGw0JAK1Jk2xZUGQz74/mCqu4joUHMpR3MDi4hJuW9J1DA')
good1 = packet('arm', 1, 0.1, ARM, 'r/pYgXGMSb+GTpzKS8BqVmr6cFlKDg8ug+jCRMzZXvZdGHdbFcLM9SVAsvqai0vJIG55T715z/cuYtBORFOkBw')
forged = packet('arm', 2, 0.9, ARM, '3vckC9z+U78EJ0EHkPUHdW0ZYENNbdbWpw+OHqbOKPnwf/xIlPchRuL/wAUogO4Fx0aba7eYuj6dgFCR2K7tDw')
stranger = packet('arm', 4, 0.1, STRANGER, 'QtlQtAzXVbkI3RIx/UMgR556HLUvUzbcVDEhuNd/d5E7/BJ80vDXRO7dKNZolL4pBTYlFzVu30Kqz4mlJlJQDw')
gantry = packet('gantry', 5, 0.1, ARM, '/Z17DkSvNQIs3IRB/f3qyDIGro7JVuRleBYKnGf5BJYEh9wnPrl14Nd+6uLDLsI7l9dLANMAKcwvBdHxwOEoCg')
late = packet('arm', 6, 0.1, ARM, 'r5eYs0BUCJHEBYwaRoaftVQNiqJ6sZ+j7yxz0FNqJ3ApQSXzBNME61FiyzHxjVD/WokIhEdlCOZNvoVmYiayBw')
datagrams = [(0.0, b''.join(good0)), (0.1, b''.join(good1)), (0.15, b''.join(good1)), (0.2, b''.join(forged)),
             (0.3, b'RK1 arm@r 3 1700000000.3\njoints arm 0.3 0\n'), (0.4, b''.join(stranger)),
             (0.5, b''.join(gantry)), (0.6, late[0] + b'sig nonsense\n'), (11.0, b''.join(late))]


def capture(name, datagrams):
    """A pcap of raw IPv4 frames."""
    with open(name, 'wb') as file:
        file.write(struct.pack('<IHHiIII', 0xa1b2c3d4, 2, 4, 0, 0, 65535, 101))
        for after, payload in datagrams:
            udp = struct.pack('>HHHH', 5000, 19960, 8 + len(payload), 0) + payload
            ip = struct.pack('>BBHHHBBH4s4s', 0x45, 0, 20 + len(udp), 1, 0, 64, 17, 0, b'\x7f\0\0\1', b'\x7f\0\0\1')
            words = struct.unpack('>10H', ip)
            total = sum(words)
            total = (total & 0xffff) + (total >> 16)
            ip = ip[:10] + struct.pack('>H', 0xffff - total) + ip[12:]
            frame = ip + udp
            file.write(struct.pack('<IIII', 1700000000 + int(after), round(after % 1 * 1e6), len(frame), len(frame)) + frame)


capture('all.pcap', datagrams)
capture('good.pcap', datagrams[:2])
END
echo "# record"
rocinante record pcap://./all.pcap --trust trusted.toml -o kept.mcap 2>/dev/null | sed 's/kept.mcap.*/kept.mcap/'
rocinante log cat kept.mcap --format json | grep -o 'RK1 arm@r [0-9]*'
echo "# spy"
rocinante spy pcap://./all.pcap --trust trusted.toml | grep 'not trusted'
rocinante spy pcap://./all.pcap --trust trusted.toml --json | grep -A 8 '"untrusted": {'
rocinante spy pcap://./good.pcap --json | grep untrusted || echo "without --trust: nothing"
echo "# check"
rocinante check arm.urdf --live pcap://./all.pcap --trust trusted.toml --json 2>said | grep -A 8 '"untrusted"'
grep trusted said
echo "# log verify"
rocinante log verify kept.mcap --trust trusted.toml
rocinante record pcap://./all.pcap -o all.mcap --compression none --quiet
rocinante log verify all.mcap --trust trusted.toml || echo "exit $?"
rocinante log verify all.mcap --trust trusted.toml --json >all.json || echo "exit $?"
python3 -c '
import json
all = json.load(open("all.json"))
print(all["datagrams"], all["trusted"], all["whole"], all["untrusted"]["forged"], all["listed"][1])'
echo "# one bit of a log"
rocinante record pcap://./good.pcap -o bit.mcap --compression none --quiet
rocinante log verify bit.mcap --trust trusted.toml
python3 -c '
whole = open("bit.mcap", "rb").read()
at = whole.index(b"joints arm 0.1 -0.785\nsig 9d24e2eeaf27c2a0 r/") + 12
open("bit.mcap", "wb").write(whole[:at] + bytes([whole[at] ^ 1]) + whole[at + 1:])'
rocinante log verify bit.mcap --trust trusted.toml | sed 's/checksum .*/checksum .../' || echo "exit $?"
