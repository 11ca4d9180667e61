# A picture that lacks a visual mesh is no golden and judges nothing, unless somebody insists; a collision mesh is not seen.
export ROCINANTE_USER=ada
cat >box.obj <<'OBJ'
v 0 0 0
v 1 0 0
v 0 1 0
f 1 2 3
OBJ
robot() {
  cat >robot.urdf <<URDF
<robot name="robot"><link name="body"><visual><geometry><box size="1 1 1"/></geometry></visual>
<visual><geometry><mesh filename="$1"/></geometry></visual>
<collision><geometry><mesh filename="$2"/></geometry></collision></link></robot>
URDF
}
printf 'format = 1\ncell = "robot.urdf"\n[[case]]\nname = "it"\nsize = [64, 48]\n' >suite.toml
do_it() { local status=0; rocinante golden "$@" >said 2>&1 || status=$?; sed "s/llvmpipe-[^ ]*/KEY/g" said; echo "exit $status"; }
draw() {
  local status=0; rocinante render robot.urdf --size 64x48 -o f.png --force --json >answer.json 2>/dev/null || status=$?
  python3 -c 'import json; print([w for w in json.load(open("answer.json"))["warnings"] if "incomplete" in w])'
  ls f.png; rm f.png; echo "exit $status"
}
robot nowhere.obj box.obj
draw
do_it approve suite.toml -m first
do_it run suite.toml --jobs 1
do_it approve suite.toml -m 'it is meant' --incomplete
do_it run suite.toml --jobs 1
do_it run suite.toml --jobs 1 --incomplete
echo "== a mesh that cannot be read"
printf 'v 1 2\n' >bad.obj
robot bad.obj box.obj
draw
echo "== a collision mesh"
robot box.obj nowhere.obj
draw
do_it approve suite.toml -m 'the mesh is there'
do_it run suite.toml --jobs 1
