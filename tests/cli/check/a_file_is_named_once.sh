# A mesh that is a model by itself: what is wrong with it names the file once.
printf 'solid nothing\nendsolid nothing\n' >empty.stl
rocinante check empty.stl || echo "exit $?"
rocinante model info empty.stl || echo "exit $?"
cat >box.urdf <<'URDF'
<robot name="box"><link name="body"><visual><geometry><mesh filename="empty.stl"/></geometry></visual></link></robot>
URDF
rocinante check box.urdf || echo "exit $?"
