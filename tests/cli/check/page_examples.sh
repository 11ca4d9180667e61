# The examples of docs/programs/check.md, in their order, in one folder.
python3 - <<'PY'
import os, re, subprocess
text = open(os.environ["SRC"] + "/docs/programs/check.md").read()
ran = wrong = 0
for kind, block in re.findall(r"^```(\w+)\n(.*?)^```", text, re.M | re.S):
    if kind == "files":
        for name, content in re.findall(r"^== (\S+)\n(.*?)(?=^== |\Z)", block, re.M | re.S):
            open(name, "w").write(content)
    elif kind == "console":
        for command, expected in re.findall(r"^\$ (.*)\n((?:(?!\$ ).*\n)*)", block, re.M):
            said = subprocess.run(["bash", "-c", command], capture_output=True, text=True)
            ran += 1
            if said.stdout + said.stderr != expected:
                wrong += 1
                print(f"$ {command}\n{said.stdout}{said.stderr}-- where the page says\n{expected}")
print("all true" if ran > 5 and wrong == 0 else f"{wrong} of {ran} differ")
PY
