# A motion that is judged by today's cell on both sides says nothing where the cell has changed: a run whose accepted
# cell cannot be put back is different, a session is judged by each side's own cell, and a device without a model never
# is the same.
export ROCINANTE_USER=ada XDG_CACHE_HOME=$PWD/cache
arm() { # arm NAME AXIS
  cat >"$1.urdf" <<URDF
<robot name="$1"> <link name="base"/> <link name="hand"/>
  <joint name="turn" type="revolute"> <parent link="base"/> <child link="hand"/> <axis xyz="0 0 $2"/>
    <limit lower="-3" upper="3" effort="1" velocity="9"/> </joint>
</robot>
URDF
}
cell() { # cell MODEL_OF_TWO
  printf 'format = 1\n[[device]]\nname = "one"\nmodel = "one.urdf"\n[[device]]\nname = "two"\nmodel = "%s"\n' "$1" >cell.toml
}
arm one 1
arm two 1
cell two.urdf
log() { # log NAME SIGN
  awk -v s="$2" 'BEGIN { print "t,one.turn,two.turn"; for (i = 0; i < 100; i++) print i/50 "," sin(i/20) "," s * cos(i/20) }' >"$1.csv"
  rocinante log import "$1.csv" --cell cell.toml -o "$1.mcap" >said.txt
}
log good 1
log flipped -1
printf 'format = 1\ncell = "cell.toml"\n[[run]]\nname = "r"\nalign = "origin"\n' >s.toml
rocinante golden approve s.toml --run r -m first --log good.mcap >said.txt
run() { echo "-- $1"; rocinante golden run s.toml --log "$2" 2>&1 || echo "exit $?"; }
run "as accepted" good.mcap
mv two.urdf kept.urdf
head -c 80 kept.urdf >two.urdf
run "its model is cut" flipped.mcap
arm two_v2 -1
cell two_v2.urdf
run "another model by another name" good.mcap
cp kept.urdf two_v2.urdf
run "the same model by another name" good.mcap
printf 'format = 1\n[[device]]\nname = "one"\nmodel = "one.urdf"\n' >cell.toml
run "the device has left the cell" flipped.mcap

echo "-- sessions"
cell two.urdf
session() { rocinante golden session "$@" --align origin --no-pictures 2>&1 || echo "exit $?"; }
session good.mcap flipped.mcap cell.toml
cp kept.urdf two.urdf
log a 1
arm two -1
log b 1
session a.mcap b.mcap
session a.mcap b.mcap cell.toml
