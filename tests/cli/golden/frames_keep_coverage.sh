# A frame judges the devices that the log moves: fewer than were accepted is different, in whatever
# picture.
export ROCINANTE_USER=ada XDG_CACHE_HOME=$PWD/cache
cp -r "$SRC/examples/demo/demo.cell.toml" "$SRC/examples/demo/arm" "$SRC/examples/demo"/*.urdf "$SRC/examples/demo"/*.obj \
  "$SRC/examples/demo"/*.mtl "$SRC/examples/demo/textures" "$SRC/examples/demo/session.mcap" .
cat >suite.toml <<'TOML'
format = 1
cell = "demo.cell.toml"
log = "session.mcap"
[defaults]
size = [160, 120]
[[case]]
name = "hall"
at = "7s"
layers = ["structure", "robots"]
camera = "top"
[[case]]
name = "signs"
at = "7s"
mask = ["gantry", "layer/tanks", { path = "arm/*", grow = 60 }]
TOML
golden() { rocinante golden "$@" || echo "exit $?"; }
golden approve suite.toml -m first
golden run suite.toml --json out.json
covers() {
  python3 - <<'PYTHON'
import json
for name, pictures in json.load(open("goldens/manifest.json"))["cases"].items():
    print(name, [p.get("coverage") for p in pictures])
PYTHON
}
covers
golden list suite.toml --json | grep -A4 '"coverage"'
echo "-- the cell calls the arm otherwise"
cp demo.cell.toml keep.toml
sed -i 's/^name = "arm"/name = "arn"/' demo.cell.toml
golden run suite.toml -j 2 --json out.json --junit out.xml 2>/dev/null | sed '/^why/,/^note/{/^note/!d}'
python3 -c 'import json; print(json.load(open("out.json"))["frames"][0]["coverage"])'
grep -o 'message="[^;]*' out.xml
echo "-- out of sight"
sed 's/^camera = "top"/hide = ["arm"]/' suite.toml >hidden.toml
cp keep.toml demo.cell.toml
golden approve suite.toml --only hall -m again
golden run hidden.toml --only hall | sed '/^why/,/^note/{/^note/!d}'
echo "-- accepted by an older version"
python3 - <<'PYTHON'
import json
manifest = json.load(open("goldens/manifest.json"))
for pictures in manifest["cases"].values():
    for picture in pictures:
        del picture["coverage"]
json.dump(manifest, open("goldens/manifest.json", "w"))
PYTHON
git init -q . && git add goldens suite.toml && git -c user.name=a -c user.email=a@b commit -qm old
cp -r goldens old
golden run suite.toml
golden approve suite.toml -m "with coverage"
covers
golden run suite.toml
for file in old/*.png; do cmp "$file" "goldens/${file#old/}"; done
echo "-- accepted by a version that kept devices alone"
python3 - <<'PYTHON'
import json
manifest = json.load(open("goldens/manifest.json"))
for pictures in manifest["cases"].values():
    for picture in pictures:
        picture["coverage"] = [item for item in picture["coverage"] if "/" not in item]
json.dump(manifest, open("goldens/manifest.json", "w"))
PYTHON
golden run suite.toml
golden approve suite.toml -m "with joints"
covers
echo "-- a joint is not stated"
cat >joints.py <<'PYTHON'
import sys
names = [f"joint{i}" for i in range(1, 7) if str(i) not in sys.argv[1:]]
print(",".join(["t"] + names))
for i in range(80):
    print(",".join([f"{i / 10}"] + [f"{0.1 * len(n)}" for n in names]))
PYTHON
python3 joints.py >six.csv && python3 joints.py 5 >five.csv && sed '1s/joint5/jiont5/' six.csv >misspelt.csv
printf 'format = 1\ncell = "demo.cell.toml"\ngoldens = "of_joints"\n[[case]]\nname = "arm"\nat = "7s"\nsize = [80, 60]\nlayers = ["structure"]\n' >joints.toml
for csv in six five misspelt; do rocinante log import $csv.csv --device arm -o $csv.mcap >made.txt 2>&1; done
sed -i 's/^layers = .*/layers = ["structure", "robots"]\ncamera = "top"/' joints.toml
golden approve joints.toml -m first --log six.mcap
for csv in five misspelt; do golden run joints.toml --log $csv.mcap --verbose | grep -E '^(same|different|note)'; done
echo "-- a revision that judges less"
git add goldens && git -c user.name=a -c user.email=a@b commit -qm new
cp old/manifest.json goldens
golden diff HEAD suite.toml | sed 's/ on 20[^ ]*Z//'
echo "-- two processes say what one says"
for jobs in 1 2; do golden run suite.toml --jobs $jobs --json jobs_$jobs.json >jobs_$jobs.txt 2>&1 || true; done
diff jobs_1.txt jobs_2.txt
python3 - <<'PYTHON'
import json, re
def told(jobs):
    text = re.sub(r'("\w*_ms": |"\w*_at": |"\w*seconds": )[^,\n]*', r"\1", open(f"jobs_{jobs}.json").read())
    return [line for line in text.splitlines() if '"jobs"' not in line]
one, two = told(1), told(2)
print(len(one) > 100, [pair for pair in zip(one, two) if pair[0] != pair[1]])
PYTHON
