# A recording never begins without the cell that it was to carry: nothing is made.
cat >box.urdf <<'URDF'
<robot name="box"><link name="body"><visual><geometry><mesh filename="meshes/gone.obj"/></geometry></visual></link></robot>
URDF
rocinante record 127.0.0.1:0 --cell box.urdf -o session.mcap --duration 100ms || echo "exit $?"
rocinante record 127.0.0.1:0 --cell none.cell.toml -o session.mcap --duration 100ms || echo "exit $?"
rocinante record 127.0.0.1:0 --search . -o session.mcap --duration 100ms || echo "exit $?"
ls
