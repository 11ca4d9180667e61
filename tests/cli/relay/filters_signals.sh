# An output and a subscriber that ask for signals by pattern, and for numbers that changed by 5.
cat >run.py <<'PY'
import json, signal, socket, subprocess

def listen():
    s = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    s.bind(("127.0.0.1", 0))
    s.settimeout(20)
    return s

def hear_until(s, wanted):
    """What is said after the headers of datagrams that are no restatement, until the wanted text."""
    said = ""
    while wanted not in said:
        head, _, body = s.recv(2000).decode().partition("\n")
        if head.startswith("RK1") and "restated" not in head:
            said += body
    return said

out, subscriber = listen(), listen()
relay = subprocess.Popen(
    ["rocinante", "relay", "--from", "127.0.0.1:0", "--serve", "127.0.0.1:0", "--to",
     f"127.0.0.1:{out.getsockname()[1]}", "--name", "site", "--restate", "1h", "--device", "arm",
     "--signal", "arm [lm]*", "--signal", "- *", "--json"], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
said = [relay.stderr.readline() for _ in range(3)]
ports = [int(line.rsplit(":", 1)[1]) for line in said]
ask = lambda words: subscriber.sendto(f"RKS1 {words}\n".ljust(256, "\n").encode(), ("127.0.0.1", ports[2]))
wish = "signal=arm%20* min-change=joint=100,signal%20*%20load=5"
ask(f"subscribe id=00000000000000a1 lease=30 {wish}")
cookie = subscriber.recv(2000).decode().split("cookie=")[1].strip()
ask(f"subscribe id=00000000000000a2 lease=30 {wish} cookie={cookie}")
assert " accepted " in subscriber.recv(2000).decode()
send = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
for i in range(6):
    send.sendto(f"RK1 s {i} -\nsignals arm load={i * 2} mode={'true' if i % 3 else 'false'} x={i}\nsignals - y={i}\n"
                .encode(), ("127.0.0.1", ports[0]))
send.sendto(b'RK1 s 6 -\nevent "end"\n', ("127.0.0.1", ports[0]))
print("output:", *hear_until(out, "end").splitlines(), sep="\n")
print("subscriber:", *hear_until(subscriber, "end").splitlines(), sep="\n")
relay.send_signal(signal.SIGTERM)
report = json.loads(relay.communicate(timeout=60)[0])
for each in [*report["outputs"], report["subscribers"]]:
    print([(left["kind"], left["reason"], left["count"]) for left in each["left_out"]["items"]])
PY
python3 run.py
