# The snippets of docs/ci.md that judge pictures: they pass, and fail with a report when the model changes.
box() {
  echo "<robot name=\"box\"><link name=\"body\"><visual><geometry><box size=\"1 1 $1\"/></geometry></visual></link></robot>"
}
box 1 >box.urdf
printf 'format = 1\ncell = "box.urdf"\n[defaults]\nsize = [48, 32]\n[[case]]\nname = "rest"\n' >suite.toml
cat >snippets.py <<'PY'
import os, re, shutil, subprocess, sys
try:
    import yaml
except ImportError:
    yaml = None
text = open(os.environ["SRC"] + "/docs/ci.md", encoding="utf-8").read()
blocks = re.findall(r"^```(\w+)\n(.*?)^```", text, re.M | re.S)
for kind, block in blocks:
    if yaml and kind == "yaml":
        yaml.safe_load(block)
    if kind != ("sh" if sys.argv[1] == "first" else "yaml"):
        continue
    for command in re.findall(r"rocinante golden .*", block):
        shutil.rmtree("report", ignore_errors=True)
        code = subprocess.run(["bash", "-euc", command], stdout=subprocess.DEVNULL).returncode
        made = [name for name in ("report/index.html", "golden.xml") if os.path.exists(name)]
        print(code, " ".join(command.split()[:3]), made)
PY
export ROCINANTE_USER=me
python3 snippets.py first
python3 snippets.py same
box 1.2 >box.urdf
python3 snippets.py changed
