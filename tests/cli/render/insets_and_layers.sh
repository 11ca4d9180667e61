# Windows over the main view, only some layers, looks, and a panel.
cat > box.urdf <<'URDF'
<robot name="box"><link name="body"><visual><geometry><box size="1 1 1"/></geometry></visual></link></robot>
URDF
cat > cell.toml <<'TOML'
format = 1
[[device]]
model = "box.urdf"
layer = "things"
tags = ["moving"]
[[camera]]
name = "side"
eye = [0, -4, 1]
target = [0, 0, 0]
[[inset]]
camera = "map"
[[inset]]
camera = "later"
corner = "bottom-left"
TOML
hash() { rocinante-render cell.toml --hash --size 160x120 --samples 1 "$@" 2>>said; }
with=$(hash); without=$(hash --no-insets)
test "$with" != "$without" && echo "the cell's insets are drawn"
test "$(hash --inset map)" = "$with" && echo "and may be said"
test "$(hash --inset map:top-left)" != "$with" && echo "elsewhere"
test "$(hash --layers things)" = "$(hash --hide layer/grid --hide layer/gnomon --hide layer/labels --hide layer/lines --hide layer/points)" && echo "only that layer"
test "$(hash --layers moving)" = "$(hash --layers things)" && echo "a tag is a layer"
test "$(hash --transparent layer/moving)" != "$with" && echo "with looks"
test "$(hash --overlay)" != "$with" && echo "a panel"
test "$(hash --shading plain)" != "$with" && echo "plain"
sort -u said
try() { rocinante-render cell.toml --hash --size 160x120 "$@" 2>&1 | grep -v 'warning:'; echo "exit ${PIPESTATUS[0]}"; }
try --inset later
try --inset :top-left
try --no-insets --inset map
try --layers thing
try --wireframe layer/thing
try --edges=thick
try --trail box@never
try --samples 2
try --hide bxo
try --show box/lid
try --scale 0
