# One value of each device in 100 s goes to an output and to a subscriber: the report counts those that newer ones
# replaced, also of a subscriber that has left.
cat >run.py <<'PY'
import json, signal, socket, subprocess, sys

def listen():
    s = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    s.bind(("127.0.0.1", 0))
    s.settimeout(20)
    return s

def hear(s, wanted):
    while True:
        text = s.recv(2000).decode()
        if wanted in text:
            return text

def run(*options):
    slow, subscriber = listen(), listen()
    relay = subprocess.Popen(
        ["rocinante", "relay", "--from", "127.0.0.1:0", "--serve", "127.0.0.1:0", "--to",
         f"127.0.0.1:{slow.getsockname()[1]}", "--name", "site", "--max-rate", "0.01", "--restate", "1h", *options],
        stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    said = [relay.stderr.readline() for _ in range(3)]
    ports = [int(line.rsplit(":", 1)[1]) for line in said]
    ask = lambda words: subscriber.sendto(f"RKS1 {words}\n".ljust(256, "\n").encode(), ("127.0.0.1", ports[2]))
    ask("subscribe id=00000000000000a1 lease=30 device=arm")
    cookie = hear(subscriber, "challenge").split("cookie=")[1].strip()
    ask(f"subscribe id=00000000000000a2 lease=30 device=arm cookie={cookie}")
    hear(subscriber, "accepted")
    send = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    for i in range(6):
        send.sendto(f"RK1 s {i} -\njoints arm {i}\njoints leg {i}\n".encode(), ("127.0.0.1", ports[0]))
    send.sendto(b'RK1 s 6 -\nevent "end"\n', ("127.0.0.1", ports[0]))
    hear(slow, "end")
    hear(subscriber, "end")
    ask(f"leave id=00000000000000a3 cookie={cookie}")
    # Answered after the leave.
    ask(f"keep id=00000000000000a4 cookie={cookie}")
    hear(subscriber, "no subscription")
    relay.send_signal(signal.SIGTERM)
    out, _ = relay.communicate(timeout=60)
    return out

report = json.loads(run("--json"))
print(report["outputs"][0]["conflated"], report["subscribers"]["conflated"], report["lost"])
print(*[line.split(": ", 1)[1] for line in run().splitlines() if line.startswith(("to ", "subscribers"))], sep="\n")
PY
python3 run.py
