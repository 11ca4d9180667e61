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
# Not inside `test`, where a picture that could not be drawn would differ from every other.
with=$(hash); without=$(hash --no-insets)
same() { local it; it=$(hash "${@:2}"); test "$it" = "$with" && echo "$1"; }
other() { local it; it=$(hash "${@:2}"); test "$it" != "$with" && echo "$1"; }
test "$with" != "$without" && echo "the cell's insets are drawn"
same "and may be said" --inset map
other "elsewhere" --inset map:top-left
other "the camera's cone in a map" --inset map --camera-cone
test "$(hash --inset side --camera @0,-3,2/0,0,0)" = "$(hash --inset side --camera @0,-3,2/0,0,0 --camera-cone)" &&
  echo "but not in perspective"
test "$(hash --no-insets --camera-cone)" = "$without" && echo "nor in the picture"
things=$(hash --layers things)
rest=$(hash --hide layer/grid --hide layer/gnomon --hide layer/labels --hide layer/lines --hide layer/points)
test "$things" = "$rest" && echo "only that layer"
moving=$(hash --layers moving)
test "$moving" = "$things" && echo "a tag is a layer"
other "with looks" --transparent layer/moving
other "a panel" --overlay
other "plain" --shading plain
sort -u said
try() { rocinante-render cell.toml --hash --size 160x120 "$@" 2>&1 | sed '/warning:/d' && echo "exit 0" || echo "exit $?"; }
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
