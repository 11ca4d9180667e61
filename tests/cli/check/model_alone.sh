# A bare URDF is judged alone; the report as JSON starts with its format.
cat >arm.urdf <<'URDF'
<robot name="arm">
  <link name="base"/>
  <link name="hand"/>
  <joint name="turn" type="continuous"> <parent link="base"/> <child link="hand"/> </joint>
</robot>
URDF
rocinante check arm.urdf
rocinante check arm.urdf --json
