# The snippets of docs/ci.md that check: their YAML parses, their commands run, their CTest tests pass; and all
# of them fail when the model changes under the session.
cat >cell.toml <<'TOML'
format = 1
[[device]]
name = "arm"
model = "arm.urdf"
TOML
robot() {
  echo "<robot name=\"arm\"> <link name=\"base\"/> <link name=\"hand\"/> <joint name=\"$1\" type=\"revolute\">"
  echo '<parent link="base"/> <child link="hand"/> </joint> </robot>'
}
robot turn >arm.urdf
rocinante record 127.0.0.1:0 -o session.mcap --cell cell.toml --max-packets 1 >/dev/null 2>said &
until grep -qs '^recording' said; do kill -0 $!; sleep 0.05; done
printf 'RK1 me@a 0 -\njoint arm turn=0.5\n' >packet
cat packet >"/dev/udp/127.0.0.1/$(sed -n 's/^recording.*:\([0-9]*\) to .*/\1/p' said)"  # in one write: one datagram
wait $!

cat >snippets.py <<'PY'
import os, re, subprocess, sys
text = open(os.environ["SRC"] + "/docs/ci.md").read()
blocks = re.findall(r"^```(\w+)\n(.*?)^```", text, re.M | re.S)
try:
    import yaml
except ImportError:
    yaml = None
def commands(tree):
    if isinstance(tree, dict):
        for key, value in tree.items():
            if key in ("run", "script"):
                yield from [value] if isinstance(value, str) else value
            else:
                yield from commands(value)
    elif isinstance(tree, list):
        for each in tree:
            yield from commands(each)
def run(command):
    code = subprocess.run(["bash", "-euc", command], stdout=subprocess.DEVNULL).returncode
    print(code, command.split(" --")[0], sorted(f for f in os.listdir(".") if f.startswith("check.")))
# What is accepted once comes before what is judged each time.
for kind, block in sorted(blocks, key=lambda each: each[0] != "sh"):
    if "rocinante check" not in block and kind != "cmake":
        continue
    if kind == "sh" and sys.argv[1] == "first":
        run(block.strip())
    elif kind == "yaml":
        found = (list(commands(yaml.safe_load(block))) if yaml else
                 [m.split("run: ")[-1].lstrip("- ") for m in block.splitlines() if "rocinante check" in m])
        for command in found:
            if command.startswith("rocinante check"):
                run(command.strip())
    elif kind == "cmake":
        os.makedirs("project", exist_ok=True)
        open("project/CMakeLists.txt", "w").write(block)
        subprocess.run("cp cell.toml arm.urdf session.mcap known.json project && cmake -S project -B built >cmake.log",
                       shell=True, check=True)
        tests = subprocess.run(["ctest", "--test-dir", "built"], capture_output=True, text=True)
        print(tests.returncode, re.findall(r"(\w+) \.+ *(\w+|\*+Failed)", tests.stdout))
PY
python3 snippets.py first
robot bend >arm.urdf
python3 snippets.py changed
