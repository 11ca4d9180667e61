# A run of a machine that says more than where it is: a torque twice as high for 50 ms, a mode, a unit, and what the
# suite may say about them.
export ROCINANTE_USER=ada XDG_CACHE_HOME=$PWD/cache
cat >arm.urdf <<'URDF'
<robot name="arm">
  <link name="base"/> <link name="upper"/>
  <joint name="shoulder" type="revolute"> <parent link="base"/> <child link="upper"/>
    <axis xyz="0 0 1"/> <limit lower="-2" upper="2" effort="1" velocity="9"/> </joint>
</robot>
URDF
suite() { printf 'format = 1\ncell = "arm.urdf"\n[[run]]\nname = "swing"\nalign = "origin"\n%s\n' "$1" >"$2"; }
suite '' runs.toml
# session FACTOR MODE: six seconds at 100 Hz.
session() {
  awk -v factor="$1" -v mode="$2" 'BEGIN {
    print "t,shoulder,signal arm shoulder.effort,signal - mode"
    for (i = 0; i < 600; i++) {
      t = i / 100
      effort = 4 + 3 * sin(1.3 * t)
      if (t >= 3 && t < 3.05) effort *= factor
      printf "%.2f,%.6f,%.6f,%s\n", t, sin(t), effort, (t >= 4 ? mode : "auto")
    }
  }'
}
session 1 auto >good.csv
session 2 auto >torque.csv
session 1 fault >mode.csv
cut -d, -f1,2,4 good.csv >silent.csv
rocinante golden approve runs.toml --run swing -m first --log good.csv
judge() { echo "-- $1 by $2"; rocinante golden run "$2" --log "$1" || echo "exit $?"; }
for log in good torque mode silent; do judge $log.csv runs.toml; done
suite 'limits = { "signal arm shoulder.effort" = { signal = 8 } }' wide.toml
suite 'limits = { "arm" = { signal_share = 0.02 } }' narrow.toml
suite 'mask = ["signal arm *"]' masked.toml
suite 'limits = { "signal arm shoulder.efort" = { signal = 8 } }' misspelt.toml
suite 'limits = { signal = 8 }' all.toml
suite 'limits = { "arm" = { signal = 8 } }' device.toml
suite 'limits = { signal_share = -1 }' negative.toml
suite 'limits = { "signal arm shoulder.effort" = { joint_deg = 3 }, "signal - mode" = { signal = 1 } }' kind.toml
for suite in wide narrow masked misspelt kind all device negative; do judge torque.csv $suite.toml; done
echo "-- two sessions, without a suite"
rocinante golden session good.csv torque.csv arm.urdf --no-pictures --align origin || echo "exit $?"
rocinante golden session good.csv torque.csv arm.urdf --no-pictures --align origin --signal-share 2
rocinante golden session good.csv torque.csv arm.urdf --no-pictures --signal-share -1 || echo "exit $?"
echo "-- what is accepted"
rocinante golden approve runs.toml --run swing -m "with the spike" --log torque.csv
rocinante golden run runs.toml --log torque.csv --json out.json
python3 -c 'import json; c = json.load(open("out.json"))["runs"][0]["coverage"]; print(c["judged"], c["left_out"]["total"])'
