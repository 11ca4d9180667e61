"""Captures of UDP datagrams from 127.0.0.1, by hand, for tests of decoders."""
import struct


def write_capture(path, datagrams, port):
    """datagrams: (seconds after 1700000000, bytes, port of the sender); sent to `port`."""
    with open(path, "wb") as file:
        file.write(struct.pack("<IHHiIII", 0xA1B2C3D4, 2, 4, 0, 0, 65535, 101))
        for after, payload, sender in datagrams:
            udp = struct.pack(">HHHH", sender, port, 8 + len(payload), 0) + payload
            ip = struct.pack(">BBHHHBBH4s4s", 0x45, 0, 20 + len(udp), 1, 0, 64, 17, 0,
                             b"\x7f\0\0\1", b"\x7f\0\0\1")
            total = sum(struct.unpack(">10H", ip))
            total = (total & 0xFFFF) + (total >> 16)
            frame = ip[:10] + struct.pack(">H", 0xFFFF - total) + ip[12:] + udp
            micros = round(after * 1e6)
            file.write(struct.pack("<IIII", 1700000000 + micros // 1000000, micros % 1000000,
                                   len(frame), len(frame)) + frame)


def varint(value):
    out = b""
    while value >= 0x80:
        out += bytes([value & 0x7F | 0x80])
        value >>= 7
    return out + bytes([value])


def whole(field, value):
    return varint(field << 3) + varint(value)


def real(field, value):
    return varint(field << 3 | 1) + struct.pack("<d", value)


def message(field, *parts):
    inner = b"".join(parts)
    return varint(field << 3 | 2) + varint(len(inner)) + inner


def egm(number, degrees, motors=1):
    """The feedback of an ABB controller with Externally Guided Motion, as on the wire."""
    return (message(1, whole(1, number), whole(2, 4 * number), whole(3, 2)) +
            message(2, message(1, *[real(1, each) for each in degrees]),
                    message(2, message(1, real(1, 364.5), real(2, -20.0), real(3, 594.0)),
                            message(2, real(1, 0.5), real(2, -0.5), real(3, 0.5), real(4, 0.5))),
                    message(3), message(4, whole(1, 1700000000), whole(2, 4000 * number))) +
            message(4, whole(1, motors)) + message(5, whole(1, 3)) + whole(6, 1) +
            message(8, whole(1, 2)))
