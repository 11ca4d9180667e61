# The cameras `fit` and `map`, which every cell has, are those of `render` in the window, too; the inset that would show
# the same is not drawn then.
export ASAN_OPTIONS=detect_leaks=0
demo=$SRC/examples/demo
cat >map.cell.toml <<TOML
format = 1
include = ["$demo/demo.cell.toml"]
search = ["$demo"]
[[inset]]
camera = "map"
TOML
cat >script.txt <<'SCRIPT'
panels off
seek 7.88s
camera map
frame 1
evidence map.png
camera fit
frame 1
evidence fit.png
camera fit:arm
orbit 20 10
frame 1
camera map
frame 1
evidence again.png
SCRIPT
with_display rocinante view map.cell.toml "$demo/session.mcap" --size 640x480 --samples 1 --profile reproducible \
  --script script.txt
for camera in map fit; do
  rocinante render map.cell.toml "$demo/session.mcap" --camera $camera --at 7.88s --size 640x480 --samples 1 -o there-$camera.png
  rocinante golden compare $camera.png there-$camera.png --tier exact | sed 's/^same:.*/same/'
done
rocinante golden compare map.png again.png --tier exact | sed 's/^same:.*/same/'
