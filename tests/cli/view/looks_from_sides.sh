# `look` turns the view to a side, an edge or a corner of the machine: its target and distance stay.
export ASAN_OPTIONS=detect_leaks=0
cat >box.urdf <<'URDF'
<robot name="box"><link name="body"><visual><geometry><box size="1 1 1"/></geometry></visual></link></robot>
URDF
cat >box.cell.toml <<'TOML'
format = 1
[[device]]
name = "box"
model = "box.urdf"
[[camera]]
name = "start"
eye = [0, -6, 1]
target = [0, 0, 1]
TOML
{
  for sides in front back left right top bottom isometric "bottom left back" "right front"; do
    printf 'camera start\nlook %s\nsave-camera %s\n' "$sides" "${sides// /-}"
  done
  echo quit
} >looks.txt
with_display rocinante view box.cell.toml --size 320x240 --samples 1 --script looks.txt
awk -F'[][,=" ]+' '/^name/{name = $2} /^eye/ && name != "box" && name != "start"{printf "%s:", name
  for (i = 2; i <= 4; i++) printf " %d", $i * 1000 + ($i < 0 ? -0.5 : 0.5); print ""}' box.cell.toml
echo 'look top bottom' >nowhere.txt
with_display rocinante view box.cell.toml --size 320x240 --script nowhere.txt 2>&1 || echo "exit $?"
