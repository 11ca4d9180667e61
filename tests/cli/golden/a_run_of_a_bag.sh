# What another program recorded is the log under test of a run, and an accepted one.
export ROCINANTE_USER=ada XDG_CACHE_HOME=$PWD/cache
cp -r "$SRC/examples/demo" demo && cd demo && rm -rf goldens
rocinante log export motion.mcap demo.cell.toml --ros2 -o bag.mcap >/dev/null 2>&1
cat >swing.urdf <<'URDF'
<robot name="arm">
  <link name="base"/> <link name="upper"/>
  <joint name="shoulder" type="revolute"> <parent link="base"/> <child link="upper"/>
    <axis xyz="0 0 1"/> <limit lower="-2" upper="2" effort="1" velocity="9"/> </joint>
</robot>
URDF
table() { awk -v add="$1" 'BEGIN { print "t,shoulder"; for (i = 0; i < 100; i++) print i / 20 "," i / 100 + (i > 50 ? add : 0) }'; }
table 0 >first.csv
table 0.00001 >again.csv
table 0.2 >other.csv
cat >runs.toml <<'TOML'
format = 1
cell = "swing.urdf"
[[run]]
name = "swing"
align = "origin"
TOML
run() { rocinante golden run runs.toml "$@" || echo "exit $?"; }
rocinante golden approve runs.toml --run swing -m "the first" --log swing=first.csv
run --log swing=first.csv
run --log swing=again.csv --json again.json
python3 -c 'import json; print(json.load(open("again.json"))["runs"][0]["log"])'
run --log swing=other.csv | sed 's/beyond.*//'
# The suite's own may be one, too; then it is named as the suite names it.
sed 's/^cell/log = "again.csv"\ncell/' runs.toml >own.toml
rocinante golden run own.toml --json own.json
python3 -c 'import json; print(json.load(open("own.json"))["runs"][0]["log"].split("/")[-1])'
# What was lost on the way is named.
printf '1,2,3,4\n' >>again.csv
run --log swing=again.csv
run --log swing=runs.toml | sed 's/:.*//'
# A bag.
sed 's/swing.urdf/demo.cell.toml/' runs.toml >demo.toml
rocinante golden approve demo.toml --run swing -m "a bag" --log swing=bag.mcap --replace 2>/dev/null
rocinante golden run demo.toml --log swing=bag.mcap 2>/dev/null | tail -n 1
