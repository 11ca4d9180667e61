# On a terminal a long silence has its countdown; with --gap-limit it is cut short, and there is nothing to count.
cp "$SRC/tests/data/logs/version-1.mcap" a.mcap
rocinante log shift a.mcap --by 1h -o b.mcap >/dev/null
cat >watch.py <<'PY'
import os, pty, re, select, signal, sys, time
def watch(arguments, wanted):
    pid, terminal = pty.fork()
    if pid == 0:
        os.environ["TERM"] = "xterm"
        os.execvp("rocinante-play", ["rocinante-play", "a.mcap", "b.mcap", "--to", "127.0.0.1:9"] + arguments)
    text, give_up, stopped = b"", time.monotonic() + 60, False
    while time.monotonic() < give_up:
        if not select.select([terminal], [], [], 0.1)[0]:
            continue
        try:
            read = os.read(terminal, 4096)
        except OSError:  # the other end is gone
            break
        text += read
        if not read:
            break
        if not stopped and wanted and re.search(wanted, text):
            stopped = True
            os.kill(pid, signal.SIGINT)
    os.kill(pid, signal.SIGKILL)
    _, status = os.waitpid(pid, 0)
    return text, status
text, status = watch([], rb", silent for 3\d{3}\.\d s more")
print("counts down" if b" s more" in text else text, status)
text, status = watch(["--gap-limit", "100ms"], None)
print("is short" if b"silent for" not in text else text, status)
PY
python3 watch.py
