# A live session: greeted with the state, then what comes. One who does not read is not waited for, and is
# greeted anew; hostile ones are told so or cut off, and nobody else notices.
export PYTHONPATH=$SRC/tests/serve
python3 - "$SRC/examples/demo" <<'PY'
import json
import socket
import sys
import time
from serving import Serving
from web_socket import Refused, WebSocket, packets

demo = sys.argv[1]
serving = Serving(f"{demo}/demo.cell.toml", "--live", "127.0.0.1:0", "--buffer", "64kB", "--rate", "1000", "--clients", "5")

def until(client, text):
    """The packets up to one with the text, and how many greetings began."""
    found, greetings = [], 0
    while not any(text in each for each in found):
        greets, _, more = packets(client.message())
        greetings += greets
        found += more
    return found, greetings

serving.send("RK1 arm 1 -\njoints arm 0 0.5 0 0 0 0\n")
page = WebSocket(serving.port, "rocinante.v1")
found, _ = until(page, "joints arm 0 0.5")
serving.send("RK1 arm 2 -\njoints arm 0 0.75 0 0 0 0\n")
until(page, "joints arm 0 0.75")
late = WebSocket(serving.port, "rocinante.v1", origin=f"http://127.0.0.1:{serving.port}")
greets, at, found = packets(late.message())
print("late:", greets, at > 1.6e18, len(found), "joints arm 0 0.75" in found[0])

# 30 rounds of a megabyte: more than any socket holds.
stalled = WebSocket(serving.port, "rocinante.v1", receive_buffer=4096)
line = " ".join(f"{i % 97}.{i % 89}" for i in range(3 * 1300))
for number in range(30):
    for each in range(50):
        serving.send(f"RK1 lines {number * 50 + each + 1} -\nline d{each} #ffffff width={number + 2} {line}\n")
    until(page, f"line d49 #ffffff width={number + 2} ")
serving.send("RK1 lines 1501 -\nline last #ffffff width=1 0 0 0 1 1 1\n")
until(page, "line last")
found, greetings = until(stalled, "line last")
width = max(int(each.split("width=")[1].split()[0]) for each in found if "line d0 " in each)
print("stalled:", "greeted again" if greetings > 1 else greetings, width)
stalled.close()
late.close()

foxglove = WebSocket(serving.port, "foxglove.sdk.v1")
info, advertised = json.loads(foxglove.message()), json.loads(foxglove.message())
topics = {each["topic"]: each["id"] for each in advertised["channels"]}
print("foxglove:", info["op"], "/tf/arm" in topics, "/joints/arm" in topics, "/drawings/lines" in topics)
def told(message):
    foxglove.send(message)
    return json.loads(foxglove.message())["message"]
for bad in ("{", "[]", '{"op":7}', '{"op":"setParameters"}', '{"op":"subscribe"}', '{"op":"subscribe","subscriptions":[7]}',
            '{"op":"subscribe","subscriptions":[{"id":1,"channelId":4294967296}]}',
            '{"op":"subscribe","subscriptions":[{"id":1,"channelId":4000}]}',
            '{"op":"unsubscribe","subscriptionIds":[7]}', b"\1\0\0\0\0", "[" * 65536):
    print(f"  {bad[:60]}: {told(bad)}")
joints = topics["/joints/arm"]
foxglove.send(json.dumps({"op": "subscribe", "subscriptions": [{"id": 7, "channelId": joints}]}))
message = foxglove.message()
print("  joints:", message[0], int.from_bytes(message[1:5], "little"), b"joint2" in message)
print(" ", told(json.dumps({"op": "subscribe", "subscriptions": [{"id": 8, "channelId": joints}]})))
serving.send("RK1 arm 3 -\njoints arm 0 0.25 0 0 0 0\n")
print("  again:", foxglove.message() != message)

def end_of(client):
    try:
        while True:
            client.message()
    except OSError:
        return "closed"
long = WebSocket(serving.port, "rocinante.v1")
long.send(b"x" * 70000)
print("a message of 70,000 bytes:", end_of(long))
long = WebSocket(serving.port, "foxglove.websocket.v1")
long.send(b"", claimed=1 << 62)
long.socket.sendall(b"x" * 70000)
print("a frame of 2^62 bytes:", end_of(long))
for name in (None, "chat"):
    try:
        WebSocket(serving.port, name)
    except Refused as refusal:
        print(name, *refusal.args)
for what, options in (("another page", {"origin": "http://evil.example"}), ("another host", {"host": "evil.example"})):
    try:
        WebSocket(serving.port, "rocinante.v1", **options)
    except Refused as refusal:
        print(what, *refusal.args)
for garbage in (b"\0" * 5000, b"GET / HTTP/9.9\r\n\r\n", b"\x16\x03\x01\x02\0\1\0", b"A" * 100000, b"GET " + b"/" * 9000 + b" HTTP/1.1\r\n"):
    with socket.create_connection(("127.0.0.1", serving.port)) as web:
        try:
            web.sendall(garbage)
        except OSError:
            pass
crowd = []
while len(crowd) < 3:
    try:
        crowd.append(WebSocket(serving.port, "rocinante.v1"))
    except Refused:  # those who have left are not forgotten yet
        time.sleep(0.05)
try:
    WebSocket(serving.port, "rocinante.v1")
except Refused as refusal:
    print("one more", *refusal.args)
half = crowd[0]
half.socket.sendall(b"\x82")  # half a head, then nothing
half.close()
serving.send("RK1 arm 4 -\njoints arm 0 1 0 0 0 0\n")
until(page, "joints arm 0 1 0")
print("the page still follows")
out, code = serving.stop()
print(code, "0 lost" in out, "skipped for slow clients" in out)
PY
