# The action for GitHub and the template for GitLab of examples/ci: their steps judge the demo as it is and as it is not, and
# leave what they promise to keep.
/usr/bin/python3 -c 'import yaml' 2>/dev/null || { echo "skipped: no python3-yaml"; exit 77; }
cp -r "$SRC"/examples/demo/. .
printf 'format = 1\ncell = "demo.cell.toml"\nlog = "session.mcap"\ngoldens = "mine"\n[[case]]\nname = "one"\nat = "3s"\nsize = [96, 64]\n' >suite.toml
ROCINANTE_USER=ada rocinante golden approve suite.toml -m first
cat >steps.py <<'PY'
import os, re, shutil, subprocess, sys
import yaml
folder = os.environ["SRC"] + "/examples/ci/"
action = yaml.safe_load(open(folder + "action.yml"))
template = yaml.safe_load(open(folder + "rocinante.gitlab-ci.yml"))[".rocinante"]
def run(command, env, shell):
    return subprocess.run([*shell, command], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                          env={**os.environ, **env, "GITHUB_STEP_SUMMARY": "summary.md"}).returncode
def github(given):
    inputs = {name: str(given.get(name, each["default"])) for name, each in action["inputs"].items()}
    assert set(given) <= set(inputs), given
    fill = lambda text: re.sub(r"\$\{\{ inputs\.([a-z-]+) \}\}", lambda m: inputs[m[1]], text)
    codes = []
    for step in action["runs"]["steps"]:
        if "run" in step and ("inputs.suite" not in step.get("if", "") or inputs["suite"]):
            env = {name: fill(value) for name, value in step["env"].items()}
            codes.append(run(step["run"], env, ["bash", "--noprofile", "--norc", "-eo", "pipefail", "-c"]))
        elif step.get("uses", "").startswith("github/codeql-action/upload-sarif@"):
            # Only of what was asked for, and of what is there.
            name = fill(step["with"]["sarif_file"])
            assert "inputs.upload-sarif == 'true'" in step["if"] and action["inputs"]["upload-sarif"]["default"] == "false"
            assert f"'{{0}}/{os.path.basename(name)}', inputs.results)" in step["if"]
            print("uploads", name, os.path.exists(name))
        elif "uses" in step:
            assert fill(step["with"]["path"]) == inputs["results"]
    return codes
def gitlab(given):
    names = {"cell": "CELL", "log": "LOG", "suite": "SUITE"}
    env = {**template["variables"], **{names[name]: value for name, value in given.items()}}
    return [run("\n".join(template["script"]), env, ["bash", "-eo", "pipefail", "-c"])]
for given in ({"cell": "demo.cell.toml", "log": "session.mcap", "suite": "suite.toml"},
              {"cell": "demo.cell.toml", "log": "session.mcap"}, {"suite": "suite.toml"}):
    for judge in (github, gitlab):
        shutil.rmtree("rocinante", ignore_errors=True)
        codes = judge(given)
        kept = sorted(os.listdir("rocinante"))
        print(sys.argv[1], judge.__name__, " ".join(given), codes, *kept)
PY
/usr/bin/python3 steps.py as-accepted
head -n 1 summary.md
sed -i 's/<limit lower="[^"]*"/<limit lower="1.5"/; 0,/xyz="0 0 0\./s//xyz="0 0.2 0./' arm.urdf
/usr/bin/python3 steps.py changed
