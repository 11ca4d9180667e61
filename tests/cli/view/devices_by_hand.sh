# A device is moved, turned, undone and saved into the cell, whose other bytes stay; the picture is then that of the
# saved cell. One of an included file is written only when that is said; what packets place is not moved.
export ASAN_OPTIONS=detect_leaks=0
cat >box.urdf <<'URDF'
<robot name="box"><link name="body"><visual><geometry><box size="1 0.5 0.2"/></geometry></visual></link></robot>
URDF
cat >site.cell.toml <<'TOML'
format = 1
[[device]]
name = "pole"   # stands there
model = "box.urdf"
TOML
cat >box.cell.toml <<'TOML'
format = 1   # ours
include = ["site.cell.toml"]
[[device]]
name = "box"
model = "box.urdf"
pose = { xyz = [0, 0, 1.00], rpy_deg = [0, 0, 0] }  # measured

[[camera]]
name = "front"
eye = [4, -6, 3]
target = [0, 0, 0]
TOML
cp box.cell.toml before.toml
view() { with_display rocinante view box.cell.toml --size 320x240 --samples 1 --profile reproducible --script "$1" 2>&1 || echo "exit $?"; }
cat >moves.txt <<'SCRIPT'
panels off
move box 1m 250mm 1
turn box 0 0 30deg
turn box 0 0 90deg
undo
frame 1
save-pose
screenshot moved.png
quit
SCRIPT
view moves.txt
diff before.toml box.cell.toml || true
rocinante render box.cell.toml --camera front --size 320x240 --samples 1 -o saved.png
printf 'panels off\nframe 1\nscreenshot again.png\n' >again.txt
view again.txt
rocinante golden compare again.png saved.png
printf 'move pole 0 2 0\nsave-pose\n' >pole.txt
view pole.txt
printf 'move pole 0 2 0\nframe 1\nsave-pose pole included\n' >included.txt
view included.txt
cat site.cell.toml
# Two of them: what could be written is told with what could not.
printf 'move box 0 0 1.5\nmove pole 0 3 0\nsave-pose\n' >both.txt
view both.txt
for line in 'undo' 'move nobody 0 0 0' 'move box here 0 0' 'save-pose' 'save-pose box yes' 'put-back box' \
  'turn box 0 0 1e999' 'move box 1e300 0 0' 'turn box 0 0 360001deg'; do
  echo "$line" >fault.txt
  view fault.txt
done
printf 'move box 0 0 2\nframe 1\nevidence e.png\n' >evidence.txt
view evidence.txt
