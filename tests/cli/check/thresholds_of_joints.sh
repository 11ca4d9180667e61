# A threshold of a joint of its own: names that the cell does not have, and rules that take none, are faulted.
cat >arm.urdf <<'XML'
<robot name="arm">
  <link name="base"/> <link name="hand"/> <link name="tip"/>
  <joint name="turn" type="revolute">
    <parent link="base"/> <child link="hand"/> <axis xyz="0 0 1"/>
    <limit lower="-2" upper="2" effort="9" velocity="1"/>
  </joint>
  <joint name="weld" type="fixed"> <parent link="hand"/> <child link="tip"/> </joint>
</robot>
XML
cat >site.cell.toml <<'TOML'
format = 1
[rules]
"joint.limit" = { rad_or_m = 0.2, "arm/turn" = { rad_or_m = 0.1 } }
TOML
cat >cell.toml <<'TOML'
format = 1
include = ["site.cell.toml"]
[[device]]
model = "arm.urdf"
[rules]
"joint.limit" = { severity = "warning", "arm/tern" = { rad_or_m = 0.1 }, "arm/weld" = { rad_or_m = 0.1 }, "amr" = { rad_or_m = 0.1 } }
"joint.velocity" = { "arm/turn" = { rad_s = 1 } }
"source.jitter" = { "arm/turn" = { ms = 3 } }
"joint.acceleration" = { "arm/turn" = { per_s2 = 0 }, "arm" = { per_s2 = 3, s = 2 } }
TOML
rocinante check cell.toml || echo "exit $?"
# What an included cell says of a joint holds where the cell itself says nothing of it.
cat >quiet.cell.toml <<'TOML'
format = 1
include = ["site.cell.toml"]
[[device]]
model = "arm.urdf"
[rules]
"joint.limit" = { "arm" = { rad_or_m = 0.01 } }
TOML
export XDG_CACHE_HOME=$PWD/cache
for turn in 2.09 2.11; do
  printf 't,turn\n0,%s\n0.1,%s\n' $turn $turn >turn.csv
  rocinante check quiet.cell.toml turn.csv --quiet || echo "exit $?"
done
