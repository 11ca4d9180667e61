# A suite without goldens fails and leaves the frame; approved it passes; another picture is different.
export ROCINANTE_USER=ada
box() {
  cat >box.urdf <<URDF
<robot name="box"><link name="body"><visual><geometry><box size="1 1 $1"/></geometry>
<material name="red"><color rgba="1 0 0 1"/></material></visual></link></robot>
URDF
}
box 1
cat >suite.toml <<'TOML'
format = 1
cell = "box.urdf"
[[case]]
name = "at-rest"
size = [160, 120]
[[case]]
name = "small"
size = [64, 48]
samples = 1
TOML
run() { rocinante golden run suite.toml "$@" | sed 's/llvmpipe-[^ ]*/KEY/' && echo "exit 0" || echo "exit $?"; }
run --report out
ls out
rocinante golden approve suite.toml -m first
run
grep -c '"accepted_by": "ada"' goldens/manifest.json
# Approving what is accepted already changes nothing, not even who and when.
cp goldens/manifest.json before.json
ROCINANTE_USER=eve rocinante golden approve suite.toml -m again >/dev/null
cmp before.json goldens/manifest.json && echo "manifest unchanged"
box 1.5
run --only small --report out --junit junit.xml | sed '/^why/d; /^    /d'
ls out
grep -c '<failure message="different' junit.xml
rocinante golden run suite.toml --only 'small' --json | grep -E '"(format|verdict)"' || echo "exit $?"
# A golden that nobody accepted judges nothing.
box 1
cp goldens/at-rest.*.png swapped.png
cp swapped.png "$(ls goldens/small.*.png)"
box 1.5
run --only small | sed 's/small\.[0-9a-f]*/small.HASH/'
