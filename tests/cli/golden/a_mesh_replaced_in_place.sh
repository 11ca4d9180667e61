# A mesh that was replaced in place is named by its groups where the accepted log carries the cell.
export ROCINANTE_USER=ada XDG_CACHE_HOME=$PWD/cache
box() { # NAME: a group of its own
  printf 'g %s\n' "$1"
  for corner in '0 0 0' '0.1 0 0' '0 0.1 0' '0 0 0.1'; do printf 'v %s\n' "$corner"; done
  printf 'f -4 -2 -3\nf -4 -3 -1\nf -4 -1 -2\nf -3 -2 -1\n'
}
{ box body; box screw1; box screw2; } >hand.obj
cat >arm.urdf <<'URDF'
<robot name="arm"><link name="base"/>
<link name="hand"><visual><geometry><mesh filename="hand.obj"/></geometry></visual></link>
<joint name="turn" type="revolute"><parent link="base"/><child link="hand"/><axis xyz="0 0 1"/>
<limit lower="-2" upper="2" effort="9" velocity="9"/></joint></robot>
URDF
printf 'format = 1\n[[device]]\nmodel = "arm.urdf"\n' >cell.toml
printf 'format = 1\ncell = "cell.toml"\n[[run]]\nname = "turn"\nalign = "origin"\n' >runs.toml
for i in $(seq 10 99); do echo "0.$i,0.$i"; done | sed '1i t,turn' >before.csv
sed 's/,0.5/,0.6/' before.csv >now.csv
rocinante log import before.csv --cell cell.toml -o before.mcap >made.txt
sed '$d' before.csv >shorter.csv
rocinante log import shorter.csv --device arm -o bare.mcap >made.txt
rocinante log import now.csv --device arm -o now.mcap >made.txt
for log in before bare; do
  echo "-- $log"
  { box body; box screw1; box screw2; } >hand.obj
  rocinante golden approve runs.toml --run turn -m first --log $log.mcap --replace | tail -1
  { box body; box screw1; } >hand.obj
  rocinante golden run runs.toml --log now.mcap | sed -n '/^why/,/^1 run/p' || echo "exit $?"
done
