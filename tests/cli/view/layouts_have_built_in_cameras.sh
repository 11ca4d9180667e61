# The built-in camera of a layout is there for the very next command, or gives way to it; those that fit a device are
# known, of the view and of an inset.
export ASAN_OPTIONS=detect_leaks=0
demo=$SRC/examples/demo
show() { with_display rocinante view "$@" --size 320x240 --samples 1 --profile reproducible --script script.txt; }
printf '%s\n' 'format = 1' 'camera = "map"' >map.layout.toml
cat >script.txt <<'SCRIPT'
panels off
layout map.layout.toml
evidence map.png
save-layout same
frame 1
screenshot shown.png
layout map.layout.toml
camera overview
frame 1
save-layout other
SCRIPT
show "$demo/demo.cell.toml" "$demo/session.mcap"
grep camera same.layout.toml other.layout.toml
rocinante golden compare map.png shown.png
# That of the command line waits for the first frame, and gives way as well.
printf '%s\n' 'format = 1' 'camera = "fit:arm"' 'insets = ["fit:arm:top-left", "fit:leg"]' >fit.layout.toml
cat >script.txt <<'SCRIPT'
camera overview
frame 1
save-layout other
layout fit.layout.toml
await-line no device is named `leg`, so there is no camera `fit:leg` for an inset
save-layout fitted
SCRIPT
show "$demo/demo.cell.toml" "$demo/session.mcap" --layout map.layout.toml
grep -E 'camera|insets = ..' other.layout.toml fitted.layout.toml
# A cell without cameras, whose window is fitted anyway.
printf '%s\n' 'format = 1' "search = [\"$demo\"]" '[[device]]' 'name = "arm"' 'model = "arm.urdf"' >arm.cell.toml
printf '%s\n' 'frame 1' 'save-layout arm' >script.txt
show arm.cell.toml --layout fitted.layout.toml
grep camera arm.layout.toml
