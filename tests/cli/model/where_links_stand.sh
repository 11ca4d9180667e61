# Forward kinematics by position, by name, in degrees, of one device, and of a recorded moment.
cat >arm.urdf <<'URDF'
<robot name="arm">
  <link name="base"/> <link name="elbow"/> <link name="tip"/>
  <joint name="turn" type="revolute"> <parent link="base"/> <child link="elbow"/> <axis xyz="0 0 1"/>
    <origin xyz="0 0 1"/> <limit lower="-3" upper="3" effort="1" velocity="1"/> </joint>
  <joint name="reach" type="prismatic"> <parent link="elbow"/> <child link="tip"/> <axis xyz="1 0 0"/>
    <limit lower="0" upper="1" effort="1" velocity="1"/> </joint>
</robot>
URDF
rocinante model fk arm.urdf --joints "-0.5 0.25"
rocinante model fk arm.urdf --degrees --joint turn=90 --joint reach=0.5 --pose "10 0 0" --json
rocinante model fk "$SRC/examples/demo/demo.cell.toml" --device gantry --log "$SRC/examples/demo/session.mcap" --at 7.88
