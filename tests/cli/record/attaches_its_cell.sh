# A log that was recorded with --cell is looked at alone, when the cell is gone; pictures are the same bits.
mkdir -p cell/meshes
cat >cell/meshes/box.obj <<'OBJ'
mtllib box.mtl
v 0 0 0
v 1 0 0
v 0 1 0
v 0 0 1
usemtl red
f 1 3 2
f 1 2 4
f 2 3 4
f 3 1 4
OBJ
printf 'newmtl red\nKd 1 0 0\n' >cell/meshes/box.mtl
cat >cell/box.urdf <<'URDF'
<robot name="box"><link name="body"><visual><geometry><mesh filename="meshes/box.obj"/></geometry></visual></link></robot>
URDF
printf 'format = 1\n[[device]]\nname = "box"\nmodel = "box.urdf"\n' >cell/a.cell.toml
cell_at_rest=$(rocinante check cell/a.cell.toml | tail -n 1)
rocinante record 127.0.0.1:0 --cell cell/a.cell.toml -o session.mcap --duration 100ms 2>/dev/null | sed -e 's/([0-9.]* k*B)/(SIZE)/' -e 's/:[0-9]* (/:PORT (/'
rocinante log extract session.mcap --list | awk '{print $1, $3, $4}'
mv cell elsewhere
rocinante log extract session.mcap --cell -o again
diff -r elsewhere again && echo "the same files"
test "$(rocinante check again/a.cell.toml | tail -n 1)" = "$cell_at_rest" && echo "$cell_at_rest"
