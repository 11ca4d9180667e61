# A robot becomes a cell over one OBJ with the same kinematics; a pose becomes an OBJ and an STL.
cat >arm.urdf <<'URDF'
<robot name="arm">
  <link name="base"> <visual> <geometry> <box size="1 1 0.5"/> </geometry> </visual> </link>
  <link name="tip"> <visual> <geometry> <box size="0.2 0.2 1"/> </geometry> </visual> </link>
  <joint name="turn" type="revolute"> <origin xyz="0 0 0.75"/> <parent link="base"/> <child link="tip"/>
    <axis xyz="0 1 0"/> <limit lower="-1.5" upper="1.5" effort="1" velocity="1"/> </joint>
</robot>
URDF
rocinante model convert arm.urdf -o arm.cell.toml
cat arm.cell.toml
rocinante model convert arm.urdf -o bent.obj --degrees --joints 90
rocinante model convert arm.urdf -o bent.stl --degrees --joints 90
rocinante model info bent.obj | grep size
rocinante model info bent.stl | grep size
rocinante model info arm.cell.toml | grep hash
rocinante model info arm.urdf | grep hash
rocinante model convert arm.urdf -o arm.cell.toml || echo "exit $?"
rocinante model convert arm.urdf -o arm.cell.toml --force
