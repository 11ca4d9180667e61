# The block of docs/ci.md that takes the pictures that CI drew, as a folder and as a ZIP file: what it accepts is what
# drawing here accepts, without the log. Nothing that was not seen, or has changed since, is accepted.
# Skipped without libzip: a folder is taken by the same code then.
grep -q "^  zip *on" <(rocinante --version --parts 2>/dev/null) || { echo "skipped: no libzip"; exit 77; }
cat >box.urdf <<'URDF'
<robot name="box"><link name="body"><visual><geometry><box size="1 1 1"/></geometry></visual></link></robot>
URDF
cat >suite.toml <<'TOML'
format = 1
cell = "box.urdf"
[defaults]
size = [64, 48]
samples = 1
[[case]]
name = "a"
[[case]]
name = "b"
mask = ["box/body"]
TOML
export ROCINANTE_USER=ada
listed() {
  python3 -c 'import json, sys
for frame in json.load(open(sys.argv[1]))["frames"]:
    print(frame["name"], frame["pixels"], sep="\t")' "$1"
}
zipped() { python3 -m zipfile -c "$1" "$2"; }
# What CI keeps: the report, with other files.
mkdir -p ci/job
rocinante golden run suite.toml --report ci/job/report >/dev/null || echo "exit $?"
echo log >ci/job/session.mcap
listed ci/job/report/report.json >list.txt
zipped session.zip ci/job/
awk '/approves_an_artifact.sh runs this block/ {found = 1} found && /^```/ {if (inside) exit; inside = 1; next} inside' \
  "$SRC/docs/ci.md" >block.sh
grep -c . block.sh
bash -eu block.sh
mv goldens from_zip
rocinante golden approve suite.toml --artifact ci --from list.txt -m 'the box is taller now'
mv goldens from_folder
rocinante golden approve suite.toml --from list.txt -m 'the box is taller now'
for other in from_zip from_folder; do
  python3 - "$other" <<'PY'
import json, os, sys
def read(folder):
    text = open(folder + "/manifest.json").read()
    manifest = json.loads(text)
    for pictures in manifest["cases"].values():
        for picture in pictures:
            picture["accepted_at"] = ""
    return manifest, sorted(os.listdir(folder))
print("as drawn here:", read("goldens") == read(sys.argv[1]))
PY
done
rocinante golden run suite.toml | tail -1
# Again: nothing changes.
rocinante golden approve suite.toml --artifact session.zip --from list.txt -m again
echo "a taller box:"
sed 's/size="1 1 1"/size="1 1 2"/' -i box.urdf
rocinante golden run suite.toml --report taller >/dev/null || echo "exit $?"
listed taller/report.json >taller.txt
# What was seen is another picture.
rocinante golden approve suite.toml --artifact taller --from list.txt -m x || echo "exit $?"
# Another key than its picture's, a mask that the suite lost, and a golden that was replaced meanwhile.
cp -r taller other_key && sed 's/64x48 1x/64x48 4x/' -i other_key/report.json
rocinante golden approve suite.toml --artifact other_key --from taller.txt -m x 2>&1 | sed 's/`[^`]* 64x/`KEY 64x/' || true
sed 's/^mask.*//' suite.toml >maskless.toml
rocinante golden approve maskless.toml --artifact taller --from taller.txt -m x || echo "exit $?"
rocinante golden list suite.toml --verify | tail -1
python3 - <<'PY'
import json
manifest = json.load(open("goldens/manifest.json"))
for pictures in manifest["cases"].values():
    for picture in pictures:
        picture["pixels"] = "0" * 32
json.dump(manifest, open("goldens/manifest.json", "w"))
PY
rocinante golden approve suite.toml --artifact ci --from taller.txt -m x || echo "exit $?"
rocinante golden approve suite.toml --artifact taller --from taller.txt -m x || echo "exit $?"
echo "broken:"
cp -r taller changed && cp changed/a.golden.png changed/a.frame.png
rocinante golden approve suite.toml --artifact changed --from taller.txt -m x || echo "exit $?"
zipped changed.zip changed/
rocinante golden approve suite.toml --artifact changed.zip --from taller.txt -m x || echo "exit $?"
mkdir two && cp -r taller two/a && cp -r taller two/b
rocinante golden approve suite.toml --artifact two --from taller.txt -m x 2>&1 | sed 's/([^()]*, [^()]*)/(TWO)/' || true
zipped none.zip suite.toml
rocinante golden approve suite.toml --artifact none.zip --from taller.txt -m x || echo "exit $?"
head -c 300 session.zip >cut.zip
# The reason is in the words of libzip, which differ by its version.
rocinante golden approve suite.toml --artifact cut.zip --from taller.txt -m x 2>&1 | sed "s/read: .* (/read: REASON (/" || echo "exit $?"
rocinante golden approve suite.toml --artifact none --from taller.txt -m x || echo "exit $?"
rocinante golden approve suite.toml --artifact ci -m x || echo "exit $?"
