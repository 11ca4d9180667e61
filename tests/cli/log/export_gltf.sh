# A session as an animated glTF scene; what glTF cannot hold is named.
cp "$SRC/examples/demo/session.mcap" session.mcap
cell="$SRC/examples/demo/demo.cell.toml"
rocinante log export session.mcap "$cell" --gltf -o scene.glb
rocinante log export session.mcap "$cell" --gltf --every 0.5s --from 2s --until 4s -o part.glb --json 2>/dev/null
echo "== a log that carries its cell"
rocinante log attach session.mcap --cell "$cell" -o carries.mcap >/dev/null
rocinante log export carries.mcap --gltf -o carried.glb 2>/dev/null
cmp scene.glb carried.glb && echo "the same scene"
rocinante model info scene.glb | sed -n 1,3p
echo "== images that glTF does not have"
printf 'BM' >dots.bmp
printf 'newmtl dots\nmap_Kd dots.bmp\n' >sheet.mtl
printf 'mtllib sheet.mtl\nusemtl dots\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nf 1/1 2/2 3/3\n' >sheet.obj
printf 'format = 1\n[[model]]\nname = "sheet"\nobj = "sheet.obj"\nunit = "m"\nup = "z"\n[[device]]\nname = "sheet"\nmodel = "sheet"\n' >sheet.cell.toml
rocinante log export session.mcap sheet.cell.toml --gltf -o sheet.glb 2>&1 | sed "s|$PWD/||" || echo "exit $?"
echo "== what links show, and findings, for Foxglove"
rocinante log export session.mcap "$cell" --foxglove --model --findings --until 1s -o shown.mcap --json 2>/dev/null |
  grep -A2 -E '"/(model/(arm|gantry)|events)"'
try() { rocinante log export "$@" || echo "exit $?"; }
try session.mcap "$cell" --ros2 --model -o x.mcap
try session.mcap "$cell" --pcap --findings -o x.pcap
try session.mcap --foxglove --findings -o x.mcap
echo "== refused"
try session.mcap --gltf -o x.glb
try session.mcap "$cell" --gltf -o x.gltf
try session.mcap "$cell" --gltf --raw -o x.glb
try session.mcap "$cell" --gltf --every 0s -o x.glb
try session.mcap "$cell" --gltf --from 1h -o x.glb
try session.mcap "$cell" --foxglove --every 1s -o x.mcap
try session.mcap "$cell" --gltf -o scene.glb
(ulimit -f 40; try session.mcap "$cell" --gltf -o full.glb)
ls
