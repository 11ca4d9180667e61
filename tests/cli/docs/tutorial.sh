# docs/tutorial.md from its first block to its last, in one folder: files are saved, commands run and answer with the exit
# code that the page says, and what they print is what it shows. The port is a free one.
export ROCINANTE_USER=me
# Under LeakSanitizer: what the X11 driver keeps has no name any more when the process ends.
export ASAN_OPTIONS=detect_leaks=0
python3 - <<'PY'
import os, re, shutil, socket, subprocess
page = open(os.environ["SRC"] + "/docs/tutorial.md", encoding="utf-8").read()
with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as probe:
    probe.bind(("127.0.0.1", 0))
    port = probe.getsockname()[1]
page = page.replace("19960", str(port))
# A listener is there when its port is taken: on a busy machine that is later than a second.
listening = f"until grep -q ':{port:04X} ' /proc/net/udp; do sleep 0.05; done"
window = shutil.which("Xvfb") and shutil.which("rocinante-view")
said, steps, faults = "", 0, []
for remark, kind, block in re.findall(r"(?:^<!-- ([^\n]*) -->\n)?^```(\w+)\n(.*?)^```$", page, re.M | re.S):
    if remark.startswith("file: "):
        open(remark.removeprefix("file: "), "w").write(block)
        if kind == "yaml" and "- run: sh ci.sh\n" not in block:
            faults.append(f"{remark} does not run ci.sh")
    elif kind == "sh":
        commands = block.replace("sleep 1\n", listening + "\n")
        if commands.startswith("rocinante view "):
            if not window:
                continue
            open("script.txt", "w").write("frame 2\nquit\n")
            commands = "with_display " + commands.strip() + " --script script.txt"
        ran = subprocess.run(["bash", "-euc", commands], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        said, steps = ran.stdout, steps + 1
        if ran.returncode != int((re.match(r"exit (\d)", remark) or "x0")[1]):
            faults.append(f"exit code {ran.returncode} of\n{block}{said}")
    elif kind == "text":
        # Line by line, in this order; "..." alone is any number of lines, within one any characters.
        shown = [r"(?:.*\n)*?" if line == "..." else r"\s+".join(
            ".*".join(map(re.escape, word.split("..."))) for word in line.split()) + r"\s*\n" for line in block.splitlines()]
        shown = "".join(r"[ ]*" + line if not line.startswith("(?:") else line for line in shown)
        if not re.search("^" + shown, said, re.M):
            faults.append(f"the page shows\n{block}of\n{said}")
print("\n".join(faults) or f"all true in {'more than 10' if steps > 10 else steps} steps")
PY
