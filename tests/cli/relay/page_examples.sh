# Runs every example of docs/programs/relay.md unchanged, for a moment, in a private network
# namespace, where its ports are free and its addresses exist.
if ! unshare -n true 2>/dev/null; then
  echo "skipped: no network name space here: needs root"
  exit 77
fi
cat >run.py <<'PY'
import os, re, shlex, signal, subprocess
page = open(os.environ["SRC"] + "/docs/programs/relay.md", encoding="utf-8").read()
blocks = re.findall(r"^```\n(.*?)^```", page, re.M | re.S)
commands = [line for block in blocks for line in block.splitlines() if line.startswith("rocinante relay ")]
commands = [line for line in commands if "[" not in line]  # but for the synopsis
ran = 0
for command in commands:
    program = subprocess.Popen(shlex.split(command), stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    ready = program.stderr.readline()
    program.send_signal(signal.SIGTERM)
    out, rest = program.communicate(timeout=60)
    ran += 1
    if program.returncode != 0 or not ready.startswith("listening on "):
        print(f"$ {command}\nexit {program.returncode}\n{ready}{rest}{out}")
print("all are taken" if ran >= 3 else f"only {ran} examples")
PY
ip=$(command -v ip)
unshare -n bash -eu -o pipefail -c "$ip link set lo up && $ip link add eth1 type veth peer name site2 && $ip addr add 10.0.0.1/24 dev eth1 && $ip link set eth1 up
python3 run.py"
