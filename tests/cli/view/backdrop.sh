# The window shows a real camera's picture behind the model as render does, of its camera alone and while it is switched
# on; what it draws by child programs: a video of a part, and a case of a suite.
export ASAN_OPTIONS=detect_leaks=0
demo=$SRC/examples/demo
cp "$demo/session.mcap" session.mcap
cat > cell.cell.toml <<CELL
format = 1
include = ["$demo/demo.cell.toml"]
search = ["$demo"]
[[camera]]
name = "bench"
eye = [3.9, -9.6, 3.2]
target = [0.05, -0.2, 1.52]
intrinsics = { fx = 410, fy = 400, cx = 150.5, cy = 123.25, width = 320, height = 240 }
distortion = [-0.2, 0.05, 0.001, 0]
CELL
rocinante render cell.cell.toml session.mcap --at 2 --camera bench --size 320x240 --no-insets -o photo.png
cat >script.txt <<'SCRIPT'
seek 7.88s
panels off
frame 2
screenshot window.png
evidence evidence.png
backdrop-opacity 0.25
backdrop-offset 3s
frame 2
screenshot weaker.png
evidence weaker-evidence.png
backdrop off
frame 2
screenshot without.png
evidence without-evidence.png
backdrop on
orbit 10 0
frame 2
screenshot turned.png
evidence turned-evidence.png
SCRIPT
look() { with_display rocinante view cell.cell.toml session.mcap --size 320x240 --profile reproducible \
  --script script.txt "$@" 2>&1 || echo "exit $?"; }
look --backdrop photo.png
for picture in window weaker without turned; do
  other=$picture-evidence.png
  [ $picture = window ] && other=evidence.png
  rocinante golden compare $picture.png $other
done
cmp -s window.png weaker.png || echo "weaker is another picture"
# By child programs.
mkdir bin
cat > bin/ffmpeg <<'SH'
#!/bin/sh
for last; do :; done
wc -c > "${last#file:}"
SH
chmod +x bin/ffmpeg
cat >script.txt <<'SCRIPT'
panels off
camera bench
select arm
nearest on
frame 2
part 2s 2.2s
video part.mp4
seek 2.5s
golden-case first
golden-case
SCRIPT
(PATH=$PWD/bin:$PATH look)
tr -d ' ' < part.mp4
cat view.suite.toml
# Refused by its line.
for line in 'video' 'backdrop off' 'backdrop-opacity 2'; do
  echo "$line" > script.txt
  look
done
echo 'backdrop-opacity 2' > script.txt
look --backdrop photo.png
look --backdrop photo.png,camera=overview
look --backdrop none.png
