# Shards put together tell what one run tells: the same page, with masks, small pictures, causes and commands.
export ROCINANTE_USER=ada
box() {
  cat >box.urdf <<URDF
<robot name="box"><link name="body"><visual><origin xyz="$1 0 0"/><geometry><box size="1 1 1"/></geometry>
<material name="red"><color rgba="$2 0.2 0.1 1"/></material></visual></link></robot>
URDF
}
cat >suite.toml <<'TOML'
format = 1
cell = "box.urdf"
[defaults]
size = [96, 72]
samples = 1
[tolerance.lax]
tile_mean = 200.0
tile_over = 256
[[case]]
name = "moved"
[[case]]
name = "fine"
tolerance = "lax"
[[case]]
name = "masked"
mask = [{ rectangle = [0, 0, 48, 72] }, { rectangle = [90, 70, 1, 1] }]
[[case]]
name = "new"
hide = ["layer/grid"]
[[case]]
name = "lax"
tolerance = "lax"
hide = ["layer/gnomon"]
TOML
box 0 0.8
rocinante golden approve suite.toml -m first --only fine --only moved --only masked --only lax | tail -1
box 0.1 0.7
rocinante golden run suite.toml --report whole --json whole.json >whole.txt || echo "exit $?"
for i in 1 2; do rocinante golden run suite.toml --shard $i/2 --report part-$i >/dev/null || echo "exit $?"; done
rocinante golden report part-2 part-1 --report merged --json merged.json >merged.txt || echo "exit $?"
grep -E '^[0-9]|note' merged.txt
cat >same.py <<'PYTHON'
import json, re, sys
def page(folder):
    text = open(folder + "/index.html").read()
    pictures = dict(re.findall(r'id="(picture-\d+)">([^<]*)<', text))
    data = json.loads(re.search(r'id="data">(.*?)</script>', text, re.S)[1])
    data["environment"] = [one for one in data["environment"] if one["name"] != "made at"]
    for frame in data["frames"]:
        frame["pictures"] = {name: pictures[f"picture-{at}"] for name, at in frame["pictures"].items()}
    return data
def verdicts(file):
    root = json.load(open(file))
    del root["made_at"]
    for frame in root["frames"]:
        del frame["render_ms"], frame["judge_ms"]
    return root
one, other = page("whole"), page("merged")
for a, b in zip(one["frames"], other["frames"]):
    for key in sorted(a.keys() | b.keys()):
        if a.get(key) != b.get(key):
            print(a["name"], key, str(a.get(key))[:200], "is not", str(b.get(key))[:200])
    print(a["name"], a["verdict"], *a["pictures"])
print("pages:", one == other, "verdicts:", verdicts("whole.json") == verdicts("merged.json"))
PYTHON
python3 same.py
# The pictures of another run are not believed, and a part without its small pictures still merges.
mv part-1/moved.frame.png kept.png
cp part-2/new.frame.png part-1/moved.frame.png
rocinante golden report part-1 part-2 --report merged 2>&1 || echo "exit $?"
mv kept.png part-1/moved.frame.png
rm part-2/page-pictures.json
rocinante golden report part-2 part-1 --json 2>&1 | grep -c verdict || echo "exit $?"
ls -A part-2
