# A real SIGINT or SIGTERM ends an import within a run or an approval, and nothing half made stays.
# The table is so long that it is never hashed.
export ROCINANTE_USER=ada
printf '<robot name="arm"><link name="base"/></robot>' >arm.urdf
printf 't,arm.a\n0,1\n' >long.csv
truncate -s 64G long.csv
printf 'format = 1\ncell = "arm.urdf"\n[[run]]\nname = "swing"\nalign = "origin"\n' >runs.toml
# stopped SIGNAL BIT COMMAND...: the signal is sent once the program catches it: that bit of what it catches.
stopped() {
  local signal=$1 bit=$2
  shift 2
  # Not by a job of the shell, which would ignore SIGINT.
  python3 - "$signal" "$bit" "$@" <<'PY'
import signal, subprocess, sys
name, bit, command = sys.argv[1], int(sys.argv[2]), sys.argv[3:]
said = open("said", "w")
program = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=said)
caught = 0
while not caught >> bit & 1:
    lines = open(f"/proc/{program.pid}/status").read().splitlines()
    caught = int(next(line for line in lines if line.startswith("SigCgt")).split()[1], 16)
program.send_signal(getattr(signal, name))
print(name, command[1], "exit", program.wait())
PY
  sed 's/stopped.*/stopped/' said
}
stopped SIGINT 1 rocinante-golden run runs.toml --log swing=long.csv
stopped SIGTERM 14 rocinante-golden run runs.toml --log swing=long.csv
stopped SIGINT 1 rocinante-golden approve runs.toml --run swing -m "one" --log swing=long.csv
stopped SIGTERM 14 rocinante-golden approve runs.toml --run swing -m "one" --log swing=long.csv
ls -A "$XDG_CACHE_HOME"/rocinante/imports 2>/dev/null || true
ls
