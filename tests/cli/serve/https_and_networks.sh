# A certificate makes it https and wss, and nothing else; a client outside --allow gets no answer; a port that is
# taken gets a sentence.
command -v openssl >/dev/null || { echo "skipped: there is no openssl here"; exit 77; }
export PYTHONPATH=$SRC/tests/serve
certificate() {
  openssl req -x509 -newkey ec -pkeyopt ec_paramgen_curve:prime256v1 -nodes -keyout "$1.key" -out "$1.pem" -days 2 \
    -subj "/CN=$1" -addext "subjectAltName=IP:127.0.0.1" 2>/dev/null
}
certificate robot
certificate other
python3 - "$SRC/examples/demo" <<'PY'
import socket
import ssl
import subprocess
import sys
from serving import Serving
from web_socket import WebSocket, packets

cell = f"{sys.argv[1]}/demo.cell.toml"
trusting = ssl.create_default_context(cafile="robot.pem")
serving = Serving(cell, "--live", "127.0.0.1:0", "--tls-cert", "robot.pem", "--tls-key", "robot.key", tls=trusting)
print(serving.said[-1].split(" at ")[1].split(":")[0])
status, head, body = serving.get("/")
print("page", status, b"<!-- rocinante page 2 -->" in body)
page = WebSocket(serving.port, "rocinante.v1", origin=f"https://127.0.0.1:{serving.port}", tls=trusting)
serving.send("RK1 arm 1 -\njoints arm 0 0.5 0 0 0 0\n")
found = []
while not found:
    found = packets(page.message())[2]
print("live", "joints arm 0 0.5" in found[0])
try:
    ssl.create_default_context(cafile="other.pem").wrap_socket(
        socket.create_connection(("127.0.0.1", serving.port), 30), server_hostname="127.0.0.1")
except ssl.SSLCertVerificationError:
    print("another certificate is not trusted")
def plain(request):
    """What a client without TLS gets."""
    with socket.create_connection(("127.0.0.1", serving.port), 30) as web:
        web.sendall(request)
        try:
            return web.recv(1 << 16)
        except ConnectionResetError:
            return b""
print("without TLS:", b"200" in plain(b"GET / HTTP/1.1\r\nHost: 127.0.0.1\r\n\r\n"))
print("it still serves", serving.get("/")[0])
print(serving.stop()[1])
def serve(*arguments):
    done = subprocess.run(["rocinante-serve", cell, "--live", "127.0.0.1:0", "--viewer", "viewer", *arguments],
                          stderr=subprocess.PIPE, text=True, timeout=60)
    print(done.returncode, done.stderr.strip().splitlines()[-1].replace(str(taken), "PORT"))
with socket.create_server(("127.0.0.1", 0)) as other:
    taken = other.getsockname()[1]
    serve("--listen", f"127.0.0.1:{taken}")
serve("--listen", "127.0.0.1:0", "--tls-cert", "robot.pem", "--tls-key", "other.key")

few = Serving(cell, f"{sys.argv[1]}/session.mcap", "--allow", "127.0.0.2/32")
print("allowed:", few.get("/", source="127.0.0.2")[0])
try:
    print("not allowed:", few.ask("GET / HTTP/1.1\r\nHost: 127.0.0.1\r\n\r\n"))
except ConnectionResetError:
    print("not allowed: b''")
print(few.process.stderr.readline().strip())
few.stop()
PY
