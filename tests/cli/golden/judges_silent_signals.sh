# Signals that are stated regularly and then no more, from 5 s on, and one that is stated when it changes: in a suite, in
# JSON, and between two sessions.
export ROCINANTE_USER=ada XDG_CACHE_HOME=$PWD/cache
cat >arm.urdf <<'URDF'
<robot name="arm">
  <link name="base"/> <link name="upper"/>
  <joint name="shoulder" type="revolute"> <parent link="base"/> <child link="upper"/>
    <axis xyz="0 0 1"/> <limit lower="-2" upper="2" effort="1" velocity="9"/> </joint>
</robot>
URDF
printf 'format = 1\ncell = "arm.urdf"\n[[run]]\nname = "hold"\nalign = "origin"\n' >runs.toml
# session FILE FORCE STATES LAMP: 12 s at 100 Hz; from 5 s on the force and the states are sent no more where it says so.
session() {
  awk -v force="$2" -v states="$3" -v lamp="$4" 'BEGIN {
    print "t,shoulder,signal arm force,signal arm clamp,signal arm state,signal - estop,signal - lamp"
    for (i = 0; i < 1200; i++) {
      t = i / 100
      printf "%.2f,%.6f,", t, 0.1 * t
      printf "%s,", (t < 5 || force) ? 5 : ""
      if (t < 5 || states) printf "true,auto,false,"; else printf ",,,"
      print (i == 0 ? "false" : i == lamp ? "true" : "")
    }
  }' >"$1"
}
session good.csv 1 1 300
session again.csv 1 1 301
session force.csv 0 1 300
session all.csv 0 0 300
rocinante golden approve runs.toml --run hold -m first --log good.csv
for log in good again force all; do
  echo "-- $log"
  rocinante golden run runs.toml --log $log.csv --json $log.json || echo "exit $?"
done
python3 - <<'PY'
import json
for its in json.load(open("force.json"))["runs"][0]["findings"]:
    print(its["kind"], its["item"], its["unit"], its["largest"], its["first_accepted_ns"], its["until_accepted_ns"])
PY
echo "-- two sessions, either way"
rocinante golden session good.csv force.csv arm.urdf --no-pictures --align origin || echo "exit $?"
rocinante golden session force.csv good.csv arm.urdf --no-pictures --align origin || echo "exit $?"
