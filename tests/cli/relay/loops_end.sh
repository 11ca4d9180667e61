# Two relays that subscribe at each other: a source of one number that has ended is forwarded once by each; the first
# prints that its datagrams come back. A relay does not subscribe at itself.
cat >run.py <<'PY'
import json, signal, socket, subprocess

def listen():
    s = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    s.bind(("127.0.0.1", 0))
    s.settimeout(30)
    return s

probe = listen()
serve_b = probe.getsockname()[1]
hear_a, hear_b = listen(), listen()

def relay(name, *options):
    return subprocess.Popen(["rocinante", "relay", "--name", name, "--json", *options],
                            stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)

def port_of(line):
    return int(line.rsplit(":", 1)[1])

a = relay("a", "--from", "127.0.0.1:0", "--from", f"subscribe://127.0.0.1:{serve_b}", "--serve", "127.0.0.1:0",
          "--to", f"127.0.0.1:{hear_a.getsockname()[1]}")
lines = [a.stderr.readline() for _ in range(4)]
from_a, serve_a = port_of(lines[0]), port_of(lines[3])
probe.close()
b = relay("b", "--from", f"subscribe://127.0.0.1:{serve_a}", "--serve", f"127.0.0.1:{serve_b}",
          "--to", f"127.0.0.1:{hear_b.getsockname()[1]}")
subscribed = 0
for relay_ in (a, b):
    while True:
        line = relay_.stderr.readline()
        if line.startswith("subscribed"):
            break
send = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
send.sendto(b"RK1 arm 0 -\njoints arm 1\n", ("127.0.0.1", from_a))
print(hear_a.recv(2000).decode().splitlines()[0], "|", hear_b.recv(2000).decode().splitlines()[0])
print(a.stderr.readline().split(" after ")[0])
# The same from the same port is a restart.
send.sendto(b"RK1 arm 0 -\njoints arm 1\n", ("127.0.0.1", from_a))
hear_a.recv(2000)
hear_b.recv(2000)
for s in (hear_a, hear_b):
    s.settimeout(0.5)
    try:
        print("goes round:", s.recv(2000))
    except TimeoutError:
        print("silence")
a.send_signal(signal.SIGTERM)
b.send_signal(signal.SIGTERM)
report, other = json.loads(a.communicate(timeout=60)[0]), json.loads(b.communicate(timeout=60)[0])
print("a:", report["applied"], "applied", report["looped"], "looped", report["loop"]["source"], report["loop"]["after"] < 30)
print("b:", other["applied"], "applied", other["looped"], "looped", other["loop"])
PY
python3 run.py
rocinante relay --from subscribe://127.0.0.1:41998 --serve :41998 || echo "exit $?"
