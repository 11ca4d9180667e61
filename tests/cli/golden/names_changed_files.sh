# Nothing is kept of the accepted cell but its picture, and still a failure names the changed files.
export ROCINANTE_USER=ada
cat >plate.urdf <<'URDF'
<robot name="plate"><link name="body"><visual><geometry><mesh filename="plate.obj"/></geometry></visual></link></robot>
URDF
plate() { printf 'mtllib plate.mtl\nusemtl paint\nv 0 0 0\nv 1 0 0\nv 1 %s 0\nv 0 1 0\nf 1 2 3 4\n' "$1" >plate.obj; }
paint() { printf 'newmtl paint\nKd %s 0.2 0.2\n' "$1" >plate.mtl; }
plate 1
paint 0.9
cat >suite.toml <<'TOML'
format = 1
cell = "plate.urdf"
[[case]]
name = "at-rest"
size = [160, 120]
TOML
why() { rocinante golden run suite.toml --report report | sed '/: the /!d' && echo "exit 0" || echo "exit $?"; }
rocinante golden approve suite.toml -m first
why
echo "a corner is moved:"
plate 1.2
why
echo "and the paint is another:"
paint 0.2
why
grep -c 'plate.obj: the mesh has changed' report/report.json
echo "accepted:"
rocinante golden approve suite.toml -m 'the plate is painted'
why
grep -c '"plate.obj"' goldens/manifest.json
echo "a mesh that is missing:"
rm plate.obj
rocinante golden run suite.toml 2>/dev/null || echo "exit $?"
