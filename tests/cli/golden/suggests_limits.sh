# Recordings of one run, in which the joint rests a little differently each time.
export XDG_CACHE_HOME=$PWD/cache
cat >swing.urdf <<'URDF'
<robot name="arm">
  <link name="base"/> <link name="upper"/>
  <joint name="shoulder" type="revolute"> <parent link="base"/> <child link="upper"/>
    <axis xyz="0 0 1"/> <limit lower="-2" upper="2" effort="1" velocity="9"/> </joint>
</robot>
URDF
cat >runs.toml <<'TOML'
format = 1
cell = "swing.urdf"
[[run]]
name = "swing"
align = "origin"
TOML
for i in 0 2 4 6; do
  awk -v add="0.00$i" 'BEGIN { print "t,shoulder"; for (i = 0; i < 100; i++) print i / 20 "," 0.5 + add }' >$i.csv
done
rocinante golden suggest runs.toml --run swing 0.csv 2.csv 4.csv 6.csv
echo "-- what is printed is what the suite takes"
rocinante golden suggest runs.toml --run swing 0.csv 2.csv 4.csv 6.csv 2>/dev/null >>runs.toml
rocinante golden suggest runs.toml --run swing 0.csv 2.csv 4.csv 6.csv
echo "-- what cannot be"
rocinante golden suggest runs.toml --run swing 0.csv 2.csv || echo "exit $?"
rocinante golden suggest runs.toml --run none 0.csv 2.csv 4.csv || echo "exit $?"
rocinante golden suggest runs.toml --run swing 0.csv 2.csv nowhere.csv || echo "exit $?"
