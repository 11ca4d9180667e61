# needs: shared
# The real Panda in the real waste yard: a window under Xvfb and OSMesa draw the same bytes.
# Under LeakSanitizer: what the X11 driver keeps has no name any more when the process ends.
export ASAN_OPTIONS=detect_leaks=0
cat >yard.cell.toml <<TOML
format = 1
search = ["$SHARED/robots/franka_panda", "$SHARED/env/waste_yard"]
[[model]]
name = "yard"
obj = "waste_yard.obj"
unit = "m"
up = "z"
[[device]]
name = "yard"
model = "yard"
[[device]]
name = "panda"
model = "panda.urdf"
pose = { xyz = [0, 0, 0.5] }
[[camera]]
name = "panda"
eye = [3, -3, 2]
target = [0, 0, 0.8]
TOML
printf 'panels off\nclear\nframe 2\nscreenshot window.png\nquit\n' >script.txt
with_display rocinante view yard.cell.toml --camera panda --size 640x480 \
  --profile reproducible --script script.txt 2>/dev/null
rocinante render yard.cell.toml --camera panda --size 640x480 -o render.png 2>/dev/null
rocinante golden compare window.png render.png
