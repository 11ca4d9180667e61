# Two programs that draw into one file at once: both find it free, one names its picture so, and the other one says
# that it is there now. No picture is lost. The first is stopped while it writes, behind all of its looks at the name:
# tried until it was caught there.
box() { echo "<robot name=\"b\"><link name=\"l\"><visual><geometry><box size=\"$1\"/></geometry></visual></link></robot>"; }
box "1 1 1" >first.urdf
box "1 2 3" >second.urdf
python3 - <<'PY'
import hashlib, os, signal, subprocess

def start(model, size):
    return subprocess.Popen(["rocinante", "render", model, "-o", "out.png", "--size", size, "--samples", "1"],
                            stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)

def writes():
    return any(name.startswith("out.png.") for name in os.listdir())

def picture():
    return hashlib.sha256(open("out.png", "rb").read()).digest()

for attempt in range(40):
    if os.path.exists("out.png"):
        os.remove("out.png")
    first = start("first.urdf", "640x480")
    while first.poll() is None and not writes():
        pass
    first.send_signal(signal.SIGSTOP)
    if first.returncode is None:
        os.waitid(os.P_PID, first.pid, os.WSTOPPED | os.WEXITED | os.WNOWAIT)
    caught = writes() and not os.path.exists("out.png")
    second = start("second.urdf", "64x48")
    said = second.communicate()[0]
    kept = picture()
    first.send_signal(signal.SIGCONT)
    said += first.communicate()[0]
    one_wins = sorted([first.returncode, second.returncode]) == [0, 2]
    if caught or not one_wins or picture() != kept:
        break
print("one wins:", one_wins)
# Who was never caught saw it in time, in another part of the program.
print(said.replace("--force replaces it", "--force overwrites it"), end="")
print("its picture stays:", picture() == kept)
PY
ls
