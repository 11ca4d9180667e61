# Every verdict with its rule: named limits, masks, expectations, several accepted pictures, corrupt goldens.
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
[defaults]
size = [64, 48]
samples = 1
[tolerance.lax]
tile_mean = 255.0
tile_over = 256
[[case]]
name = "exact"
[[case]]
name = "lax"
tolerance = "lax"
[[case]]
name = "masked"
mask = ["box", { rectangle = [0, 0, 4, 4] }]
[[case]]
name = "nothing"
mask = [{ rectangle = [0, 0, 64, 48] }]
[[case]]
name = "idle"
mask = ["no-such-device"]
[[case]]
name = "known"
expect = "different"
reason = "the box is being redrawn"
[[case]]
name = "line-drawing"
style = { edges = "only" }
hide = ["layer/grid", "layer/gnomon"]
TOML
# What is estimated of why is another case's business.
run() {
  rocinante golden run suite.toml --jobs 1 "$@" |
    sed '/^    /d; /^why/d; s/llvmpipe-[^ ]*/KEY/; s/\.[0-9a-f]\{8\}\.png/.HASH.png/; s/[0-9]* differing/N differing/; s/mean [0-9.]*\([ ,]\)/mean M\1/; s/and [0-9]* <=/and N <=/' &&
    echo "exit 0" || echo "exit $?"
}
rocinante golden approve suite.toml -m first | tail -1
run
box 1.2
run
# Beside what is accepted already, another picture is as good.
rocinante golden approve suite.toml --only exact --also -m 'both boxes are sold' | tail -1
run --only exact
box 1
run --only exact
# A golden that is a pointer, cut off, another picture, or gone.
box 1.2
golden=$(ls goldens/lax.*.png)
cp "$golden" kept.png
printf 'version https://git-lfs.github.com/spec/v1\noid sha256:00\nsize 3\n' >"$golden"
run --only lax
head -c 100 kept.png >"$golden"
run --only lax | cut -c1-60
cp goldens/line-drawing.*.png "$golden"
rm goldens/idle.*.png
box 1
echo spare >goldens/spare.png
rocinante golden list suite.toml --verify 2>&1 | sed '/^  /d; s/\.[0-9a-f]\{8\}\.png/.HASH.png/' || echo "exit $?"
rocinante golden run suite.toml --only idle | tail -1
