# Approving in the terminal: yes, no, a look at the pictures, quit. On a pseudo terminal.
export ROCINANTE_USER=ada
cat >box.urdf <<'URDF'
<robot name="box"><link name="body"><visual><geometry><box size="1 1 1"/></geometry></visual></link></robot>
URDF
cat >suite.toml <<'TOML'
format = 1
cell = "box.urdf"
[defaults]
size = [64, 48]
samples = 1
[[case]]
name = "a"
[[case]]
name = "b"
hide = ["layer/grid"]
[[case]]
name = "c"
hide = ["layer/gnomon"]
TOML
cat >drive.py <<'PYTHON'
import os, pty, sys
answers = dict(pair.split("=") for pair in sys.argv[1].split(","))
pid, terminal = pty.fork()
if pid == 0:
    os.execvp("rocinante", ["rocinante", "golden", "approve", "suite.toml", "-i", "-m", "looked at"])
said, answered = b"", 0
while True:
    try:
        piece = os.read(terminal, 4096)
    except OSError:
        break
    if not piece:
        break
    said += piece
    if said.count(b"[q]uit: ") > answered:
        answered += 1
        name = said.rsplit(b"approve ", 1)[1].split(b"?")[0].decode()
        words = answers[name].split("+")
        os.write(terminal, (words.pop(0) + "\n").encode())
        answers[name] = "+".join(words)
status = os.waitpid(pid, 0)[1]
for line in said.decode().replace("\r", "").splitlines():
    if line.startswith("  /"):
        print("  " + os.path.basename(line.strip()), os.path.exists(line.strip()))
    else:
        print(line)
print("exit", os.waitstatus_to_exitcode(status))
PYTHON
export TMPDIR=$PWD
python3 drive.py a=v+what+y,b=n,c=yes
rocinante golden list suite.toml | awk '{print $1, $4}' || echo "exit $?"
python3 drive.py b=q
