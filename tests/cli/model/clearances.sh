# What a cell keeps apart, in one pose; and a clearance that cannot be read.
cat >arm.urdf <<'URDF'
<robot name="arm">
  <link name="base"/>
  <link name="hand">
    <collision><origin xyz="1 0 0"/><geometry><sphere radius="0.1"/></geometry></collision>
  </link>
  <joint name="turn" type="revolute"> <parent link="base"/> <child link="hand"/> <axis xyz="0 0 1"/>
    <limit lower="-2" upper="2" effort="1" velocity="3"/> </joint>
</robot>
URDF
cat >post.urdf <<'URDF'
<robot name="post">
  <link name="post"><collision><geometry><box size="0.2 0.2 1"/></geometry></collision></link>
</robot>
URDF
cat >cell.toml <<'TOML'
format = 1
[[device]]
name = "arm"
model = "arm.urdf"
[[device]]
name = "post"
model = "post.urdf"
pose = { xyz = [1.3, 0, 0] }
[[clearance]]
name = "post"
between = ["arm", "post"]
min_m = 0.12
TOML
rocinante model clearance cell.toml --device arm --joints 0.9 && echo kept
rocinante model clearance cell.toml --device arm --joints 0 || echo not kept
rocinante model clearance cell.toml --device arm --joints 0 --json || true
sed -i 's/"arm", "post"/"arm", "pots"/; s/0.12/-1/' cell.toml
rocinante model clearance cell.toml --device arm --joints 0.9 2>&1 | sed 's/^[^:]*: warning: //' || true
