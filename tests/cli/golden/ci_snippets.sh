# The pipelines of docs/ci.md, at most 20 lines each: their YAML parses, and their commands, with a port of this test's own,
# record a live session, check it and judge its pictures. Where the model changes they fail, and what they keep is there.
python3 -c 'import yaml' 2>/dev/null || { echo "skipped: no python3-yaml"; exit 77; }
robot() {
  echo "<robot name=\"arm\"> <link name=\"base\"/> <link name=\"hand\"> <visual> <geometry> <box size=\"1 1 $2\"/> </geometry> </visual> </link>"
  echo "<joint name=\"$1\" type=\"continuous\"> <parent link=\"base\"/> <child link=\"hand\"/> <axis xyz=\"0 1 0\"/> </joint> </robot>"
}
robot turn 1 >arm.urdf
printf 'format = 1\n[[device]]\nname = "arm"\nmodel = "arm.urdf"\n' >cell.toml
printf 'format = 1\ncell = "cell.toml"\nlog = "session.mcap"\n[[case]]\nname = "turned"\nevent = "turned"\nsize = [48, 32]\n' >suite.toml
cat >simulate <<'PY'
#!/usr/bin/env python3
import os, socket
to = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
for i, line in enumerate(["joint arm turn=0.1", "joint arm turn=0.5", 'event "turned"', "joint arm turn=0.5"]):
    to.sendto(f"RK1 me@a {i} -\n{line}\n".encode(), ("127.0.0.1", int(os.environ["PORT"])))
PY
chmod +x simulate
cat >snippets.py <<'PY'
import os, re, shutil, socket, subprocess, sys
import yaml
text = open(os.environ["SRC"] + "/docs/ci.md", encoding="utf-8").read()
for block in re.findall(r"^```yaml\n(.*?)^```", text, re.M | re.S):
    yaml.safe_load(block)
whole = re.findall(r"^<!-- test: whole -->\n```yaml\n(.*?)^```", text, re.M | re.S)
assert len(whole) == 2, len(whole)
# But what an artifact is needed for: approves_an_artifact.sh has one.
first = re.findall(r"^rocinante (?:golden|check) (?!.*--artifact).*", "".join(re.findall(r"^```sh\n(.*?)^```", text, re.M | re.S)), re.M)
FILES = ["session.mcap", "record.txt", "check.sarif", "check.xml", "golden.xml", "report"]
def steps(tree):
    """What one shell runs: each step of GitHub's, by sh -e; all of GitLab's together."""
    if "jobs" in tree:
        job, = tree["jobs"].values()
        return [step["run"] for step in job["steps"] if "run" in step], [name for step in job["steps"] if "with" in step
                for name in step["with"]["path"].split("\n")]
    job, = tree.values()
    kept = job["artifacts"]
    return ["\n".join(job["script"])], kept["paths"] + kept["reports"]["junit"]
def run(command):
    # A free port; nobody else of this test wants it meanwhile.
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as probe:
        probe.bind(("127.0.0.1", 0))
        port = str(probe.getsockname()[1])
    assert "19960" not in command or "127.0.0.1:19960" in command
    return subprocess.run(["sh", "-ec", command.replace("19960", port)], stdout=subprocess.DEVNULL,
                          env={**os.environ, "PORT": port, "GITHUB_STEP_SUMMARY": "page.md"}).returncode
for block in whole:
    tree = yaml.safe_load(block)
    commands, kept = steps(tree)
    for name in FILES:
        shutil.rmtree(name) if os.path.isdir(name) else os.path.exists(name) and os.remove(name)
    if sys.argv[1] == "first":
        if "jobs" not in tree:
            continue
        # Record once, and accept what came.
        code = run("\n".join(commands).split("rocinante check")[0])
        print("recorded", code, [run(command) for command in first])
        for name in FILES[:2]:
            os.remove(name)
    codes = []
    for command in commands:
        codes.append(run(command))
        if codes[-1] != 0:
            break
    print(len(block.splitlines()) <= 20 or len(block.splitlines()), codes, [name for name in FILES if os.path.exists(name)],
          sorted(set(FILES) - set(kept) - {"check.xml", "check.sarif"}))
PY
export ROCINANTE_USER=me
python3 snippets.py first
echo "the same:"
python3 snippets.py same
echo "a wider box:"
robot turn 1.2 >arm.urdf
python3 snippets.py changed
echo "another joint:"
robot bend 1 >arm.urdf
python3 snippets.py changed
