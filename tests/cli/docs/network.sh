# docs/network.md: figure 2 on one machine. Relays and recorder start in the page's order, the sources run, the viewers
# look; the recording is what check and the page say.
command -v rocinante-view >/dev/null && command -v Xvfb >/dev/null || no_window=1
export ASAN_OPTIONS=detect_leaks=0 no_window
cp -r "$SRC"/examples/demo/. . && rm -f session.mcap
python3 - <<'PY'
import os, re, signal, socket, subprocess, time
page = open(os.environ["SRC"] + "/docs/network.md", encoding="utf-8").read()
ports = []
for _ in range(5):
    probe = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    probe.bind(("127.0.0.1", 0))
    ports.append(probe)
for number, probe in zip(range(19961, 19966), ports):
    page = page.replace(str(number), str(probe.getsockname()[1]))
for probe in ports:
    probe.close()
started, faults, seen = [], [], 0

def start(name, command):
    said = open(name + ".txt", "w+")
    child = subprocess.Popen(["bash", "-c", "exec " + command], stderr=said, stdout=subprocess.DEVNULL)
    started.append((name, child))
    deadline = time.monotonic() + 60
    while "listening on" not in open(name + ".txt").read() and "subscribed to" not in open(name + ".txt").read():
        if child.poll() is not None or time.monotonic() > deadline:
            raise SystemExit(f"{name}: {open(name + '.txt').read()}")
        time.sleep(0.05)

for kind, name, block in re.findall(r"^<!-- (start|look|run)(?:: (\w+))? -->\n```sh\n(.*?)^```$", page, re.M | re.S):
    if kind == "start":
        start(name, block.strip())
    elif kind == "look" and not os.environ.get("no_window"):
        open("script.txt", "w").write("frame 30\nquit\n")
        seen += subprocess.run(["bash", "-c", "with_display " + block.strip() +
                                " --script script.txt"], stderr=subprocess.DEVNULL).returncode == 0
    elif kind == "run":
        if subprocess.run(["bash", "-euc", block], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL).returncode != 0:
            faults.append("the sources failed")
time.sleep(1)
for name, child in reversed(started):
    child.send_signal(signal.SIGINT)
    if child.wait(60) != 0:
        faults.append(f"{name}: exit {child.returncode}: {open(name + '.txt').read()}")
checked = subprocess.run(["rocinante", "check", "demo.cell.toml", "session.mcap"], capture_output=True, text=True)
if checked.returncode != 0 or not re.search(r"packets of 2 sources", checked.stdout):
    faults.append(checked.stdout + checked.stderr)
if not os.environ.get("no_window") and seen != 2:
    faults.append(f"{seen} of 2 viewers ran")
print("\n".join(faults) or "everybody heard it")
PY
