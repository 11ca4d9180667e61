# A robot at given joint values, without a session: mimic joints follow, and what the model cannot take is said.
cat >two.cell.toml <<'TOML'
format = 1
[[device]]
name = "a"
model = "arm.urdf"
[[device]]
name = "b"
model = "arm.urdf"
pose = { xyz = [0, 2, 0] }
TOML
cat >arm.urdf <<'URDF'
<robot name="arm"><link name="base"><visual><geometry><box size="0.2 0.2 0.2"/></geometry></visual></link>
<link name="hand"><visual><origin xyz="0.5 0 0"/><geometry><box size="1 0.1 0.1"/></geometry></visual></link>
<joint name="turn" type="continuous"><parent link="base"/><child link="hand"/><axis xyz="0 0 1"/></joint></robot>
URDF
draw() { rocinante render "$@" --size 64x48 --samples 1 --camera @3,-3,3/0,1,0 --hash; }
rest=$(draw two.cell.toml)
[ "$(draw two.cell.toml --joints a=0 --joints b=0)" = "$rest" ] && echo "zero is rest"
[ "$(draw two.cell.toml --joints b=1.5)" != "$rest" ] && echo "b turned"
[ "$(draw two.cell.toml --joints b=1)" = "$(draw two.cell.toml --joints b=2 --joints b=1)" ] && echo "the last one counts"
try() { draw "$@" 2>&1 || echo "exit $?"; }
try two.cell.toml --joints 1
try two.cell.toml --joints c=1
try two.cell.toml --joints a=1,2
try two.cell.toml --joints a=x
try two.cell.toml "$SRC/examples/demo/session.mcap" --at 1 --joints a=1
