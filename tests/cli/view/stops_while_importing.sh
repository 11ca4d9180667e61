# A real SIGINT or SIGTERM ends the window while it imports, and nothing half made stays. The table is
# so long that it is never hashed.
export ASAN_OPTIONS=detect_leaks=0
printf '<robot name="arm"><link name="base"/></robot>' >arm.urdf
printf 't,arm.a\n0,1\n' >long.csv
truncate -s 64G long.csv
cat >look.py <<'PY'
import os, signal, subprocess, sys
for name, bit in ("SIGINT", 1), ("SIGTERM", 14):
    program = subprocess.Popen(["rocinante-view", "arm.urdf", "long.csv", "--size", "320x240", "--fresh"],
                               stdout=subprocess.DEVNULL, stderr=open(f"said.{name}", "w"))
    # Until it catches the signal and reads the table.
    def reads():
        lines = open(f"/proc/{program.pid}/status").read().splitlines()
        caught = int(next(line for line in lines if line.startswith("SigCgt")).split()[1], 16)
        if not caught >> bit & 1:
            return False
        files = f"/proc/{program.pid}/fd"
        for file in os.listdir(files):
            try:
                if os.path.basename(os.readlink(f"{files}/{file}")) == "long.csv":
                    return True
            except FileNotFoundError:  # closed meanwhile
                pass
        return False
    while not reads():
        if program.poll() is not None:
            break
    program.send_signal(getattr(signal, name))
    with open("answers", "a") as answers:
        print(name, "exit", program.wait(), file=answers)
PY
with_display python3 look.py >/dev/null 2>&1 || true
cat answers
sed 's/stopped.*/stopped/' said.SIGINT said.SIGTERM
ls -A "$XDG_CACHE_HOME"/rocinante/imports 2>/dev/null || true
