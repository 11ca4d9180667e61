# A suite that names no cell: a run's own log is judged, and accepted, by the cell that it carries, and what differs
# between that and the accepted log's is a finding.
export ROCINANTE_USER=ada XDG_CACHE_HOME=$PWD/cache
printf 'format = 1\n[[device]]\nname = "one"\nmodel = "one.urdf"\n' >cell.toml
awk 'BEGIN { print "t,one.turn"; for (i = 0; i < 100; i++) print i/50 "," sin(i/20) }' >motion.csv
log() { # log NAME AXIS
  cat >one.urdf <<URDF
<robot name="one"> <link name="base"/> <link name="hand"/>
  <joint name="turn" type="revolute"> <parent link="base"/> <child link="hand"/> <axis xyz="0 0 $2"/>
    <limit lower="-3" upper="3" effort="1" velocity="9"/> </joint>
</robot>
URDF
  rocinante log import motion.csv --cell cell.toml -o "$1.mcap" >said.txt
}
log a 1
log b -1
rm one.urdf cell.toml
printf 'format = 1\nlog = "a.mcap"\n[[run]]\nname = "r"\nalign = "origin"\n[[run]]\nname = "s"\nalign = "origin"\n' >s.toml
for run in r s; do rocinante golden approve s.toml --run $run -m first >said.txt; done
run() { echo "-- $*"; rocinante golden run s.toml "$@" | grep -v '^note' || echo "exit $?"; }
run
run --log r=b.mcap
run --log r=b.mcap --log s=a.mcap
run --log b.mcap
echo "-- b is accepted as its own cell has it"
rocinante golden approve s.toml --run r --log r=b.mcap -m "turned" --replace
run --log r=b.mcap
run --log r=a.mcap
