# Goldens that another Mesa drew: equal pixels are the same under any key, rounding is the same where no tolerance is
# written, and what goes beyond it is not judged, with the difference and the reasons told.
export ROCINANTE_USER=ada
box() {
  cat >box.urdf <<URDF
<robot name="box"><link name="body"><visual><geometry><box size="0.2 0.2 $2"/></geometry>
<material name="grey"><color rgba="$1 0.3 0.3 1"/></material></visual></link>
<link name="floor"><visual><geometry><box size="4 4 0.02"/></geometry></visual></link>
<joint name="fixed" type="fixed"><parent link="body"/><child link="floor"/><origin xyz="0 0 -0.5"/></joint></robot>
URDF
}
# The manifest then says that another Mesa drew them, of a package that has a revision.
accept_elsewhere() {
  rm -rf goldens
  rocinante golden approve suite.toml -m first | tail -1
  sed -i 's/llvmpipe-mesa[^-]*-llvm[^-]*-/llvmpipe-mesa1.2.3-1+deb99u1-llvm4.5.6-/' goldens/manifest.json
}
run() {
  rocinante golden run suite.toml --jobs 1 "$@" |
    sed "s/renderer (llvmpipe-[^ ]*/renderer (HERE/; s/samples for llvmpipe-[^ ]*/samples for HERE/; s/-$(uname -m)-/-ARCH-/g; s/[0-9]* of 19200 pixels/N of 19200 pixels/; s/[0-9]* differing/N differing/; s/difference [0-9]* >/difference N >/; /^    /d; /^why/d" &&
    echo "exit 0" || echo "exit $?"
}
cat >suite.toml <<'TOML'
format = 1
cell = "box.urdf"
[defaults]
size = [160, 120]
hide = ["layer/grid", "layer/gnomon"]
[[case]]
name = "unsaid"
[[case]]
name = "exactly"
tolerance = "exact"
[[case]]
name = "rounded"
tolerance = "rounding"
[[case]]
name = "lax"
tolerance = "loose"
TOML
box 0.6 0.2
accept_elsewhere
echo '-- the same pixels'
run
cp goldens/manifest.json before.json
rocinante golden approve suite.toml -m again | tail -1
cmp before.json goldens/manifest.json && echo 'nothing was approved'
echo '-- one level more in the box'
box 0.604 0.2
run --junit out.xml --json out.json >/dev/null || true
grep -A 4 'name="unsaid"' out.xml | sed "1d; s/llvmpipe-[^ ]*-llvm[^-]*-$(uname -m)-sse4.1/RENDERER/"
python3 - <<'PY'
import json
frame = json.load(open("out.json"))["frames"][0]
print(frame["verdict"], frame["tolerance"], frame["limits"], frame["max"], frame["golden"]["key"] != frame["key"])
PY
run
echo '-- another box'
box 0.6 0.3
run --report report
test -e report/unsaid.golden.png && test -e report/unsaid.difference.png && echo 'the report has both pictures'
rocinante golden run suite.toml --only unsaid --verbose | grep -c 'box/body: .* differing pixels' || echo "exit $?"
echo '-- approved here too'
rocinante golden approve suite.toml --only unsaid -m 'a taller box' | tail -1
grep -c '"picture": "unsaid' goldens/manifest.json
run --only unsaid
box 0.604 0.3
run --only unsaid
echo '-- other samples are another picture'
sed -i 's/^size = .*/&\nsamples = 1/' suite.toml
run --only exactly
