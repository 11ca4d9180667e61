# Which goldens changed since a revision: one replaced, one new, one gone, one as it was.
export ROCINANTE_USER=ada GIT_CONFIG_GLOBAL=/dev/null GIT_CONFIG_NOSYSTEM=1
command -v git >/dev/null || { echo "skipped: no git"; exit 77; }
box() {
  cat >box.urdf <<URDF
<robot name="box"><link name="body"><visual><geometry><box size="1 1 $1"/></geometry></visual></link></robot>
URDF
}
suite() {
  printf 'format = 1\ncell = "box.urdf"\n[defaults]\nsize = [64, 48]\nsamples = 1\n' >suite.toml
  for name in "$@"; do printf '[[case]]\nname = "%s"\n' "$name" >>suite.toml; done
}
box 1
suite kept replaced removed
rocinante golden diff HEAD suite.toml 2>&1 | sed 's/(.*)/(FOLDER)/; s/says: .*/says so (FOLDER)/' || echo "exit $?"
git init -q . && git config user.email ada@example.org && git config user.name ada
rocinante golden approve suite.toml -m first >/dev/null
git add . && git commit -q -m goldens && git tag accepted
rocinante golden diff accepted suite.toml && echo "exit 0"
suite kept replaced added
box 2
rocinante golden approve suite.toml --only replaced --only added -m 'a higher box' >/dev/null
python3 - <<'PYTHON'
import json, os
manifest = json.load(open("goldens/manifest.json"))
for accepted in manifest["cases"].pop("removed"):
    os.remove("goldens/" + accepted["picture"])
json.dump(manifest, open("goldens/manifest.json", "w"))
PYTHON
times() { sed 's/[0-9]* differing/N differing/; s/on 2[0-9TZ:-]*/on DAY/'; }
rocinante golden diff accepted suite.toml --report out | times || echo "exit $?"
ls out
(mkdir -p elsewhere && cd elsewhere && rocinante golden diff accepted | times) || echo "exit $?"
rocinante golden diff --json - accepted suite.toml | grep -c '"name"' || echo "exit $?"
rocinante golden diff no-such suite.toml 2>&1 | sed 's/(.*)/(FOLDER)/' || echo "exit $?"
rocinante golden diff -- --upload-pack=x suite.toml 2>&1 | sed 's/(.*)/(FOLDER)/' || echo "exit $?"
