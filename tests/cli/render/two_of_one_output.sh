# Two programs that draw into one file at once: both find it free, one writes it, and the other one says that it is
# there now. No picture is lost. The first is stopped once it draws, after it has seen that the file is free.
box() { echo "<robot name=\"b\"><link name=\"l\"><visual><geometry><box size=\"$1\"/></geometry></visual></link></robot>"; }
box "1 1 1" >first.urdf
box "1 2 3" >second.urdf
python3 - <<'PY'
import glob, hashlib, signal, subprocess, time

def start(model, size):
    return subprocess.Popen(["rocinante", "render", model, "-o", "out.png", "--size", size, "--samples", "1"],
                            stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)

def draws(pid):
    for name in glob.glob(f"/proc/{pid}/task/*/comm"):
        try:
            if open(name).read().startswith("llvmpipe"):
                return True
        except OSError:
            pass
    return False

first = start("first.urdf", "2048x2048")
while first.poll() is None and not draws(first.pid):
    time.sleep(0.001)
first.send_signal(signal.SIGSTOP)
second = start("second.urdf", "64x48")
said_second = second.communicate()[0]
picture = hashlib.sha256(open("out.png", "rb").read()).digest()
first.send_signal(signal.SIGCONT)
said_first = first.communicate()[0]
codes = sorted([first.returncode, second.returncode])
print("exits", codes)
print(said_first + said_second, end="")
print("the picture stays:", hashlib.sha256(open("out.png", "rb").read()).digest() == picture)
PY
ls
