# The page and the log over HTTP: whole, by ranges, and who is refused with which sentence.
export PYTHONPATH=$SRC/tests/serve
python3 - "$SRC/examples/demo" <<'PY'
import sys
from serving import Serving
from web_socket import Refused, WebSocket

demo = sys.argv[1]
log = open(f"{demo}/session.mcap", "rb").read()
serving = Serving(f"{demo}/demo.cell.toml", f"{demo}/session.mcap", "--token", "open-sesame",
                  "--origin", "https://robot.example:8443")
token = "?token=open-sesame"
status, head, body = serving.get("/" + token)
print("page", status, b"<!-- rocinante page 2 -->" in body, b"connect-src 'self'" in body, b'data-kind="log"' in body,
      "frame" in head.lower())
print("log", serving.get("/log" + token)[2] == log, serving.get("/log", "Authorization: Bearer open-sesame")[2] == log)
for text in ("bytes=0-0", "bytes=10-19", "bytes=236440-", "bytes=-5", "bytes=5-999999999"):
    status, head, body = serving.get("/log" + token, "Range: " + text)
    said = [line.split(": ")[1] for line in head.split("\r\n") if line.startswith("content-range")]
    first, last = said[0].split(" ")[1].split("/")[0].split("-")
    print(text, status, body == log[int(first):int(last) + 1], said)
for text in ("bytes=999999999-", "bytes=5-4", "bytes=a-b", "lines=1-2", "bytes=0-1,3-4", "bytes=99999999999999999999-"):
    status, _, body = serving.get("/log" + token, "Range: " + text)
    print(text, status, "whole" if body == log else body.decode().strip())

def refused(what, answer):
    status, _, body = answer
    print(f"{what}: {status} {body.decode().strip()}")
refused("no token", serving.get("/"))
refused("wrong token", serving.get("/log?token=open-sesam"))
refused("another host", serving.get("/" + token, host="evil.example"))
refused("another port", serving.get("/" + token, host="127.0.0.1:1"))
refused("another page", serving.get("/log" + token, "Origin: http://evil.example"))
refused("a sandboxed page", serving.get("/log" + token, "Origin: null"))
refused("elsewhere", serving.get("/../../etc/passwd" + token))
refused("a socket's path", serving.get("/live" + token))
print("localhost", serving.get("/" + token, host=f"localhost:{serving.port}")[0],
      "behind a proxy", serving.get("/" + token, "Origin: https://robot.example:8443", host="robot.example:8443")[0])
# A browser always sends a short one: what is longer is not taken for none.
for size in (2040, 2200, 3500):
    try:
        status, _, body = serving.get("/log" + token, "Origin: http://" + "e" * size)
        print("an Origin of", size, status, body.decode().strip()[:60])
    except (ConnectionError, IndexError):
        print("an Origin of", size, "refused by the library")
for path, *headers in (["/"], ["/log"], ["/log", "Range: bytes=10-19"], ["/nowhere"]):
    lines = [f"HEAD {path}{token} HTTP/1.1", f"Host: 127.0.0.1:{serving.port}", "Connection: close", *headers]
    head, _, body = serving.ask("\r\n".join(lines) + "\r\n\r\n").partition(b"\r\n\r\n")
    of_get = serving.get(path + token, *headers)[1].lower()
    same = [line for line in head.decode().lower().split("\r\n") if line in of_get]
    print("HEAD", path, head.split(b"\r\n")[0].decode(), "as GET" if len(same) == len(head.split(b"\r\n")) else "unlike GET",
          len(body))
answer = serving.ask(f"POST / HTTP/1.1\r\nHost: 127.0.0.1:{serving.port}\r\nAuthorization: Bearer open-sesame\r\n"
                     "Connection: close\r\nContent-Length: 0\r\n\r\n")
print("POST", answer.split(b"\r\n")[0].decode())
try:
    WebSocket(serving.port, "rocinante.v1", "/live" + token)
except Refused as refusal:
    print("a socket:", *refusal.args)
out, code = serving.stop()
print(code, out.split(",")[0])
PY
