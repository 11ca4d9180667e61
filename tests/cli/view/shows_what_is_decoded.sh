# A live window with --decoders shows telegrams that are no packets: the picture is that of the joint that they say, and
# what the window keeps has both, the telegram as it came and the packet that was made of it.
export ASAN_OPTIONS=detect_leaks=0 XDG_CACHE_HOME=$PWD/cache
cat >lift.urdf <<'URDF'
<robot name="lift"><link name="base"><visual><geometry><box size="1 1 0.2"/></geometry></visual></link>
<link name="plate"><visual><geometry><box size="0.6 0.6 0.1"/></geometry></visual></link>
<joint name="up" type="prismatic"><parent link="base"/><child link="plate"/><axis xyz="0 0 1"/>
<limit lower="0" upper="1" effort="1" velocity="1"/></joint></robot>
URDF
cat >lift.decoders.toml <<'TOML'
[[decoder]]
name = "lift"
kind = "xml"
begins_with = "<Lift"
[[decoder.field]]
name = "height"
at = "Plate@mm"
[[decoder.joint]]
device = "lift"
joint = "up"
field = "height"
times = 0.001
TOML
port=$((20000 + $$ % 20000))
cat >lift.py <<'PY'
import socket, sys, time
s = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
while True:
    s.sendto(b'<Lift><Plate mm="400"/></Lift>', ("127.0.0.1", int(sys.argv[1])))
    time.sleep(0.03)
PY
python3 lift.py "$port" &
lift=$!
camera='@3,-3,2/0,0,0.3'
printf 'await 1.5s\npanels off\ncamera %s\nframe 2\nscreenshot window.png\nsave kept.mcap\nquit\n' "$camera" >script.txt
with_display rocinante view lift.urdf --live "127.0.0.1:$port" --decoders lift.decoders.toml --size 320x240 \
  --profile reproducible --script script.txt
kill $lift
wait $lift 2>/dev/null || true
rocinante render lift.urdf --joints 0.4 --camera "$camera" --size 320x240 -o expected.png
rocinante golden compare window.png expected.png
rocinante log cat kept.mcap | grep -o '3c4c.*' | sort -u
rocinante log info kept.mcap | sed -n 's:^  /rocinante/decoded/udp/[0-9]*/127.0.0.1  \(rk1 *decoded.lift\) .*:\1:p'
