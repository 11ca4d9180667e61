# One client opens many connections and asks nothing: a browser beside it is answered at once, from the same address or
# another, and a download that goes on is not ended for them.
export PYTHONPATH=$SRC/tests/serve
python3 - "$SRC/examples/demo" <<'PY'
import socket
import sys
import time
from serving import Serving

demo = sys.argv[1]
log = open(f"{demo}/session.mcap", "rb").read()
serving = Serving(f"{demo}/demo.cell.toml", f"{demo}/session.mcap", "--clients", "4")
slow = serving.connect("127.0.0.3")
slow.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 4096)
slow.sendall(f"GET /log HTTP/1.1\r\nHost: 127.0.0.1:{serving.port}\r\nConnection: close\r\n\r\n".encode())
began = slow.recv(100)
idle = [serving.connect() for _ in range(200)]
# Half of them have begun a request that does not end.
for each in idle[::2]:
    try:
        each.sendall(b"GET / HTTP/1.1\r\nHost: ")
    except ConnectionError:
        pass
idle += [serving.connect() for _ in range(200)]
began_at = time.monotonic()
for source in (None, "127.0.0.2"):
    print("a browser:", *[serving.get("/log", source=source)[2] == log for _ in range(5)])
# Nothing in which a timeout of the server ends.
print("at once" if time.monotonic() - began_at < 8 else "late")
answer = began
while data := slow.recv(1 << 16):
    answer += data
print("the download:", answer.partition(b"\r\n\r\n")[2] == log)
open_still = 0
for each in idle:
    each.setblocking(False)
    try:
        open_still += each.recv(1) != b""
    except BlockingIOError:
        open_still += 1
    except ConnectionError:
        pass
print("of 400 that ask nothing, at most 64 stay:", open_still <= 64)
out, code = serving.stop()
print(code)
PY
