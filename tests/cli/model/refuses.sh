# What cannot be done is said in one line: 2.
try() { status=0; rocinante model "$@" || status=$?; echo "exit $status"; }
cat >arm.urdf <<'URDF'
<robot name="arm">
  <link name="base"/> <link name="tip"/>
  <joint name="turn" type="revolute"> <parent link="base"/> <child link="tip"/> <axis xyz="0 0 1"/>
    <limit lower="-3" upper="3" effort="1" velocity="1"/> </joint>
</robot>
URDF
try info none.urdf
try fk arm.urdf --joints "1 2"
try fk arm.urdf --joint trun=1
try fk arm.urdf --joints "1 x"
try fk arm.urdf --log none.mcap
try info arm.urdf --device other
try convert arm.urdf -o arm.fbx
try convert arm.urdf -o arm.obj
sed -i 's/type="revolute"/type="spherical"/' arm.urdf
try tree arm.urdf --ascii
try tree arm.urdf --strict
