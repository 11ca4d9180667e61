# Two senders, a relay, a filtered listener, and subscribers over IPv4 and IPv6 that come late.
cat >run.py <<'PY'
import json, signal, socket, subprocess, time

def listen(family, host):
    s = socket.socket(family, socket.SOCK_DGRAM)
    s.bind((host, 0))
    s.settimeout(20)
    return s

slow = listen(socket.AF_INET, "127.0.0.1")
relay = subprocess.Popen(
    ["rocinante", "relay", "--from", "127.0.0.1:0", "--serve", "127.0.0.1:0", "--serve", "[::1]:0",
     "--to", f"127.0.0.1:{slow.getsockname()[1]}", "--name", "site", "--device", "arm*", "--restate",
     "500ms", "--json"], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
said = [relay.stderr.readline() for _ in range(4)]
ports = [int(line.rsplit(":", 1)[1]) for line in said]
send = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)

def tell(text):
    send.sendto(text.encode(), ("127.0.0.1", ports[0]))

tell("RK1 a@r 0 17.5\nadd arm1 m\njoints arm1 1 2\njoints leg 9\n")
tell("RK1 b@r 0 -\njoints arm2 3\n")
print(slow.recv(2000).decode(), end="")
print(slow.recv(2000).decode(), end="")

def hear(s, server, ask, wanted):
    """Repeats the request, as a subscriber does, until a datagram has the wanted text."""
    until = time.monotonic() + 20
    s.settimeout(1)
    if ask:
        s.sendto(ask, server)
    while time.monotonic() < until:
        try:
            data, sender = s.recvfrom(2000)
        except TimeoutError:
            if ask:
                s.sendto(ask, server)
            continue
        assert sender[:2] == server, sender
        text = data.decode()
        if wanted in text:
            return text
    raise SystemExit(f"never heard {wanted}")

sequence = 0
for family, host, port in ((socket.AF_INET, "127.0.0.1", ports[2]), (socket.AF_INET6, "::1", ports[3])):
    sequence += 1
    server = (host, port)
    s = listen(family, host)
    ask = lambda words: f"RKS1 {words}\n".ljust(256, "\n").encode()
    challenge = hear(s, server, ask("subscribe id=00000000000000a1 lease=10 source=b"), "challenge")
    cookie = challenge.split("cookie=")[1].strip()
    s.sendto(ask(f"subscribe id=00000000000000a2 lease=10 source=b cookie={cookie}"), server)
    accepted = hear(s, server, None, "accepted")
    print(accepted.rsplit("@", 1)[0])
    greeting = hear(s, server, None, "by=site")
    print("greeting:", greeting.splitlines()[1:], "restated" in greeting)
    kept = hear(s, server, ask(f"keep id=00000000000000a3 cookie={cookie}"), "kept")
    print(kept.split(" cookie")[0])
    tell(f"RK1 a@r {sequence} 18\njoints arm1 5 6\n")
    tell(f"RK1 b@r {sequence} -\njoints arm2 {sequence}\n")
    passed = hear(s, server, None, f"RK1 b@r {sequence} - via=")
    print("passes:", passed.splitlines()[1] == f"joints arm2 {sequence}")
    s.sendto(ask(f"leave id=00000000000000a4 cookie={cookie}"), server)

relay.send_signal(signal.SIGTERM)
out, _ = relay.communicate(timeout=20)
report = json.loads(out)
print("exit", relay.returncode)
print(report["received"], report["applied"] + report["late"], report["lost"], report["subscribers"]["most"],
      report["subscribers"]["now"])
PY
python3 run.py
