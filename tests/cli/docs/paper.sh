# docs/paper.md: each command of its tables runs, in the page's order, beside the programs that it starts, and prints
# what the page says that it prints. Ports are free ones; nobody reads what is sent to 19963. Windows need Xvfb, and C
# a compiler; a page gets a stand-in for the viewer, which packing does not look into.
export ASAN_OPTIONS=detect_leaks=0
cp -r "$SRC"/examples examples
ln -s "$SRC"/core core
cd examples/demo
printf 'frame 10\nquit\n' >script.txt
mkdir viewer && echo 'var rocinanteViewer;' >viewer/rocinante-viewer.js && echo wasm >viewer/rocinante-viewer.wasm
python3 - <<'PY'
import os, re, shutil, signal, socket, subprocess, time
page = open(os.environ["SRC"] + "/docs/paper.md", encoding="utf-8").read()
window = shutil.which("Xvfb") and shutil.which("rocinante-view")
sink = None
for port in ("19961", "19962", "19964", "19963"):
    sink = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    sink.bind(("127.0.0.1", 0))
    page = page.replace(port, str(sink.getsockname()[1]))
    if port != "19963":
        sink.close()
faults = []

def start(command):
    said = open(f"said-{time.monotonic_ns()}.txt", "w+")
    child = subprocess.Popen(["bash", "-c", "exec " + command], stdout=said, stderr=subprocess.STDOUT)
    deadline = time.monotonic() + 60
    while not re.search("listening on|subscribed to|sending|serving", open(said.name).read()):
        if child.poll() is not None or time.monotonic() > deadline:
            raise SystemExit(f"{command}: {open(said.name).read()}")
        time.sleep(0.05)
    return command, child, said

def end(command, child, said):
    child.send_signal(signal.SIGINT)
    if child.wait(60) != 0:
        faults.append(f"exit {child.returncode} of {command}\n{open(said.name).read()}")

beside = [start(block) for block in re.findall(r"^<!-- start -->\n```sh\n(.*?)\n```$", page, re.M | re.S)]
commands = re.findall(r"`((?:rocinante|cc|\./sender) [^`]+)`(?: prints `([^`]+)`)?", "\n".join(re.findall(r"^\|.*", page, re.M)))
for command, prints in commands:
    if command.startswith(("cc ", "./sender ")) and not shutil.which("cc"):
        continue
    if command.startswith(("rocinante relay", "rocinante serve")):
        running = start(command)
        time.sleep(0.5)
        end(*running)
        continue
    if command.startswith("rocinante view"):
        if not window:
            continue
        command = f"with_display {command} --script script.txt"
    if command.startswith("rocinante page"):
        command += " --viewer viewer"
    ran = subprocess.run(["bash", "-c", command], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    if ran.returncode != 0 or prints not in ran.stdout:
        faults.append(f"exit {ran.returncode} of {command}\n{ran.stdout[-2000:]}")
for running in reversed(beside):
    end(*running)
print("\n".join(faults) or f"all true of {'more than 30' if len(commands) > 30 else len(commands)} commands")
PY
