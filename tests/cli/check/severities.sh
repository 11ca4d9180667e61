# What says no is set by the cell, and by --rule, --strict and --fail-on for one run.
cat >cell.toml <<'TOML'
format = 1
[[device]]
name = "arm"
model = "arm.urdf"
TOML
cat >arm.urdf <<'URDF'
<robot name="arm">
  <link name="base"/>
  <link name="hand"/>
  <joint name="turn" type="revolute"> <parent link="base"/> <child link="hand"/> </joint>
</robot>
URDF
rocinante check cell.toml --quiet || echo "exit $?"
rocinante check cell.toml --quiet --strict || echo "exit $?"
rocinante check cell.toml --quiet --fail-on note || echo "exit $?"
rocinante check cell.toml --quiet --rule urdf.missing-limit=error || echo "exit $?"
rocinante check cell.toml --quiet --strict --rule urdf.missing-limit=off || echo "exit $?"
rocinante check cell.toml --rule urdf.missing-limits=off || echo "exit $?"
rocinante check cell.toml --rule urdf.missing-limit=fatal || echo "exit $?"
