"""A WebSocket client of few lines (RFC 6455), which can also do what no sound client does."""
import base64
import os
import socket
import struct


class Refused(Exception):
    """The server answered with something else than 101: status and text."""


class WebSocket:
    mask = bytes(4)  # of zeros, which leaves data as it is; some servers want others

    def __init__(self, port, protocol, path="/live", host=None, origin=None, headers=(), receive_buffer=None,
                 tls=None):
        self.socket = socket.socket()
        if receive_buffer:
            self.socket.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, receive_buffer)
        self.socket.settimeout(20)
        self.socket.connect(("127.0.0.1", port))
        self.socket.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        if tls:
            self.socket = tls.wrap_socket(self.socket, server_hostname="127.0.0.1")
        key = base64.b64encode(os.urandom(16)).decode()
        lines = [f"GET {path} HTTP/1.1", f"Host: {host or f'127.0.0.1:{port}'}", "Connection: Upgrade",
                 "Upgrade: websocket", "Sec-WebSocket-Version: 13", f"Sec-WebSocket-Key: {key}"]
        lines += [f"Sec-WebSocket-Protocol: {protocol}"] if protocol else []
        lines += [f"Origin: {origin}"] if origin else []
        lines += list(headers)
        self.socket.sendall(("\r\n".join(lines) + "\r\n\r\n").encode())
        self.buffer = b""
        while b"\r\n\r\n" not in self.buffer:
            self._more()
        head, self.buffer = self.buffer.split(b"\r\n\r\n", 1)
        self.head = head.decode()
        status = self.head.split(None, 2)[1]
        if status != "101":
            try:
                while True:
                    self._more()
            except ConnectionError:
                pass
            raise Refused(status, self.buffer.decode().strip())

    def _more(self):
        data = self.socket.recv(1 << 16)
        if not data:
            raise ConnectionError("closed by the server")
        self.buffer += data

    def _take(self, count):
        while len(self.buffer) < count:
            self._more()
        data, self.buffer = self.buffer[:count], self.buffer[count:]
        return data

    def frame(self):
        """(opcode, is the last of its message, payload)."""
        first, second = self._take(2)
        size = second & 0x7F
        if size == 126:
            size, = struct.unpack(">H", self._take(2))
        elif size == 127:
            size, = struct.unpack(">Q", self._take(8))
        return first & 15, bool(first & 0x80), self._take(size)

    def message(self):
        """The next text (str) or binary message; answers pings. A close is a ConnectionError with its code."""
        whole, kind = b"", None
        while True:
            opcode, is_last, data = self.frame()
            if opcode == 9:
                self.send(data, opcode=10)
                continue
            if opcode == 8:
                raise ConnectionError(struct.unpack(">H", data[:2])[0] if len(data) >= 2 else None)
            if opcode == 10:
                continue
            kind = opcode or kind
            whole += data
            if is_last:
                return whole.decode() if kind == 1 else whole

    def send(self, data, opcode=None, last=True, claimed=None):
        """`claimed`: the size that the frame's head says, if it is not that of the data."""
        if isinstance(data, str):
            data, opcode = data.encode(), 1 if opcode is None else opcode
        opcode = 2 if opcode is None else opcode
        size = len(data) if claimed is None else claimed
        head = bytes([(0x80 if last else 0) | opcode])
        if size < 126:
            head += bytes([0x80 | size])
        elif size < 65536:
            head += bytes([0x80 | 126]) + struct.pack(">H", size)
        else:
            head += bytes([0x80 | 127]) + struct.pack(">Q", size)
        if any(self.mask):
            data = bytes(each ^ self.mask[i % 4] for i, each in enumerate(data))
        self.socket.sendall(head + self.mask + data)

    def close(self):
        self.socket.close()


def packets(message):
    """Of a message of rocinante.v1: (greets, time in ns, [packet])."""
    greets, time = struct.unpack_from("<bq", message)
    at, found = 9, []
    while at < len(message):
        size, = struct.unpack_from("<I", message, at)
        found.append(message[at + 4:at + 4 + size].decode())
        at += 4 + size
    assert at == len(message)
    return bool(greets), time, found
