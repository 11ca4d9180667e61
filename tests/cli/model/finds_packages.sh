# Pictures beside the meshes of a package, and packages in folders of another name: found where that
# is allowed, else told with what was looked for and what is near.
mkdir -p share/anymal_data/anymal/urdf share/anymal_data/anymal/meshes outside
triangle='v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nf 1/1 2/1 3/1\n'
robot() {
  echo '<robot name="r"><link name="base"><visual><geometry>'
  echo "<mesh filename=\"$1\"/></geometry></visual></link></robot>"
}
cd share/anymal_data/anymal
printf "mtllib base.mtl\nusemtl skin\n${triangle}usemtl hull\n${triangle}" >meshes/base.obj
printf 'newmtl skin\nmap_Kd skin.png\nnewmtl hull\nmap_Kd ../../../../outside/hull.png\n' >meshes/base.mtl
touch meshes/skin.png ../../../outside/hull.png
robot package://anymal_data/anymal/meshes/base.obj >urdf/anymal.urdf
cd ../../..
rocinante model info share/anymal_data/anymal/urdf/anymal.urdf
rocinante model info share/anymal_data/anymal/urdf/anymal.urdf --json |
  python3 -c 'import json, sys; print(json.load(sys.stdin)["textures_missing"])'

mkdir -p irb/meshes irb/urdf
printf "$triangle" >irb/meshes/base.obj
robot package://irb_support/meshes/base.obj >irb/urdf/irb.urdf
rocinante model info irb/urdf/irb.urdf | grep -E 'missing'
echo '--package'
rocinante model info irb/urdf/irb.urdf --package irb_support=irb | grep -E 'missing|geometry'
rocinante check irb/urdf/irb.urdf --package irb_support=irb --quiet
echo '[packages]'
cat >irb.cell.toml <<'TOML'
format = 1
[packages]
irb_support = "irb"
[[device]]
model = "irb/urdf/irb.urdf"
TOML
rocinante model info irb.cell.toml | grep -E 'missing|geometry'
echo 'package.xml'
echo '<package><name>irb_support</name></package>' >irb/package.xml
rocinante model info irb/urdf/irb.urdf | grep -E 'missing|geometry'
rocinante model info irb/urdf/irb.urdf --package irb_support || true
rocinante model info irb/urdf/irb.urdf --package irb_support=gone || true
