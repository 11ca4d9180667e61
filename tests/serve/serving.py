"""A `rocinante serve` for a test: on free ports, stopped at the end, also of a test that fails."""
import atexit
import os
import re
import signal
import socket
import subprocess


class Serving:
    def __init__(self, *arguments, address="127.0.0.1", tls=None):
        """`address` as in a URL; `tls`: the ssl.SSLContext of clients of a server with a certificate."""
        os.makedirs("viewer", exist_ok=True)
        for name in ("rocinante-viewer.js", "rocinante-viewer.wasm"):
            with open(f"viewer/{name}", "w") as file:
                file.write("a stand-in\n")
        self.process = subprocess.Popen(
            ["rocinante-serve", *arguments, "--listen", f"{address}:0", "--viewer", "viewer"],
            stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        atexit.register(self.process.kill)
        self.address, self.tls = address, tls
        self.said = []
        while not (self.said and self.said[-1].startswith("serving")):
            line = self.process.stderr.readline()
            if not line:
                raise RuntimeError("serve has ended: " + " ".join(self.said))
            self.said.append(line.strip())
        self.port = int(re.search(rf"https?://{re.escape(address)}:(\d+)/", self.said[-1]).group(1))
        udp = re.search(r"udp://127\.0\.0\.1:(\d+)", self.said[-1])
        self.udp = int(udp.group(1)) if udp else None
        self.sender = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)

    def send(self, packet):
        self.sender.sendto(packet.encode(), ("127.0.0.1", self.udp))

    def connect(self, source=None):
        """A socket to the server, from the address `source`."""
        web = socket.create_connection((self.address.strip("[]"), self.port), 30, source and (source, 0))
        return self.tls.wrap_socket(web, server_hostname=self.address) if self.tls else web

    def ask(self, request, source=None):
        """Sends bytes and returns everything until the server closes."""
        with self.connect(source) as web:
            web.sendall(request.encode() if isinstance(request, str) else request)
            answer = b""
            while data := web.recv(1 << 16):
                answer += data
        return answer

    def get(self, path, *headers, host=None, source=None):
        lines = [f"GET {path} HTTP/1.1", f"Host: {host or f'{self.address}:{self.port}'}", "Connection: close",
                 *headers]
        head, _, body = self.ask("\r\n".join(lines) + "\r\n\r\n", source).partition(b"\r\n\r\n")
        return int(head.split(None, 2)[1]), head.decode(), body

    def stop(self):
        """What it printed at the end, and its exit code."""
        self.process.send_signal(signal.SIGINT)
        out, _ = self.process.communicate(timeout=60)
        return out.strip(), self.process.returncode
