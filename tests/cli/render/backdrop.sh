# The picture of a calibrated camera, drawn by itself, lies behind the model pixel by pixel; pictures with times, a video
# (here by programs that only pretend), and what cannot be a backdrop.
cat > cell.toml <<'CELL'
format = 1
[[device]]
name = "box"
model = "box.urdf"
[[camera]]
name = "bench"
eye = [3, -4, 2.5]
target = [0.1, 0.2, 0.3]
intrinsics = { fx = 70.5, fy = 66.25, cx = 28.75, cy = 26.5, width = 64, height = 48 }
[[camera]]
name = "free"
eye = [3, -4, 2.5]
target = [0, 0, 0]
CELL
cp cell.toml cell.cell.toml
cat > box.urdf <<'URDF'
<robot name="box"><link name="body"><visual><geometry><box size="1 1.5 0.7"/></geometry></visual></link></robot>
URDF
draw() { rocinante-render cell.cell.toml --size ${size:-64x48} --samples 1 --hide layer/gnomon --hide layer/grid "$@" 2>&1 || echo "exit $?"; }
# The lens's own picture, then the same with the model hidden by it, and before it.
draw --camera bench -o real.png
draw --backdrop real.png --backdrop-opacity 1 -o over.png
draw --backdrop real.png --backdrop-opacity 0 -o behind.png
rocinante-golden compare real.png over.png
rocinante-golden compare real.png behind.png
# Without the model it is what it was, in a wide picture in the middle.
size=96x48 draw --backdrop real.png --hide box -o wide.png
rocinante-golden compare real.png wide.png >/dev/null 2>&1 || echo "another size"
# A folder: every picture until the next; without a session the moment is 0.
mkdir photos
cp real.png photos/f9.png
draw --camera free -o photos/f10.png
printf '1\n2\n' > photos/times.txt
draw --backdrop photos --backdrop-offset -1s --backdrop-opacity 1 -o first.png
draw --backdrop photos,camera=bench --backdrop-offset -2s --backdrop-opacity 1 -o second.png
rocinante-golden compare real.png first.png
rocinante-golden compare photos/f10.png second.png
# Refused, with the reason.
draw --backdrop real.png --camera free --hash
draw --backdrop real.png,camera=free --hash
draw --backdrop none.png --hash
draw --backdrop real.png,fps=0 --hash
draw --backdrop wide.png --hash
draw --backdrop-opacity 0.5 --hash
draw --backdrop real.png --backdrop-opacity 2 --hash
draw --backdrop real.png --backdrop-offset soon --hash
rm photos/times.txt
draw --backdrop photos --hash
# A video: three pictures, the second of which is the lens's. ffmpeg gets the wanted one by a moment before it.
mkdir bin
cat > bin/ffprobe <<'SH'
#!/bin/sh
printf 'packet|pts_time=0.5|flags=K_\npacket|pts_time=1.5|flags=__\npacket|pts_time=1.0|flags=__\n'
printf 'stream|width=64|height=48\nformat|start_time=0.5\n'
SH
cat > bin/ffmpeg <<'SH'
#!/bin/sh
echo "$*" | sed 's/.*\(-ss [0-9.]*\).*/\1/; t; s/.*/from the start/' >> asked.txt
[ "$MODE" = short ] && exit 0
[ "$MODE" = fail ] && { echo "Invalid data found" >&2; exit 1; }
head -c 36864 /dev/zero | tr '\0' '\377'
SH
chmod +x bin/*
touch clip.mp4
(
  PATH=$PWD/bin:$PATH
  draw --backdrop clip.mp4 --backdrop-offset -700ms --backdrop-opacity 1 -o clip.png
  cat asked.txt
  MODE=short draw --backdrop clip.mp4 --hash
  MODE=fail draw --backdrop clip.mp4 --hash
)
r=$(command -v rocinante-render)
PATH=/nowhere $r cell.cell.toml --backdrop clip.mp4 --hash 2>&1 || echo "exit $?"
