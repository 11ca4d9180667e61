# Which goldens changed, of every suite of a repository: pictures in a store outside it, a broken manifest, no goldens.
export ROCINANTE_USER=ada GIT_CONFIG_GLOBAL=/dev/null GIT_CONFIG_NOSYSTEM=1
command -v git >/dev/null || { echo "skipped: no git"; exit 77; }
box() {
  cat >box.urdf <<URDF
<robot name="box"><link name="body"><visual><geometry><box size="1 1 $1"/></geometry></visual></link></robot>
URDF
}
mkdir repository && cd repository
git init -q . && git config user.email ada@example.org && git config user.name ada
git commit -q --allow-empty -m nothing
echo '{"name": "a page", "icons": []}' >manifest.json
echo '[package]' >other.toml
rocinante golden diff HEAD 2>&1 || echo "exit $?"
box 1
printf 'format = 1\ncell = "box.urdf"\nstore = "../store"\n[[case]]\nname = "a"\nsize = [64, 48]\nsamples = 1\n' >suite.toml
rocinante golden approve suite.toml -m first >/dev/null
git add . && git commit -q -m goldens
rocinante golden diff HEAD
box 2
rocinante golden approve suite.toml -m second >/dev/null
rocinante golden diff HEAD --report ../out 2>&1 | sed 's/[0-9]* differing/N differing/; s/on 2[0-9TZ:-]*/on DAY/' || echo "exit $?"
ls ../out ../store | sed 's/[0-9a-f]\{32\}/HASH/'
# Half merged: nothing was compared.
printf '<<<<<<< ours\n' | cat - goldens/manifest.json >broken.json && mv broken.json goldens/manifest.json
rocinante golden diff HEAD 2>&1 | sed "s#$PWD/##" || echo "exit $?"
rocinante golden diff HEAD >/dev/null 2>&1 || echo "exit $?"
