# A live window with --trust shows what a listed key has signed; a thief that says the same source's later datagrams moves
# nothing there, moves the lift in a window without --trust, and is not in what the window keeps.
export ASAN_OPTIONS=detect_leaks=0 XDG_CACHE_HOME=$PWD/cache
cat >lift.urdf <<'URDF'
<robot name="lift"><link name="base"><visual><geometry><box size="1 1 0.2"/></geometry></visual></link>
<link name="plate"><visual><geometry><box size="0.6 0.6 0.1"/></geometry></visual></link>
<joint name="up" type="prismatic"><parent link="base"/><child link="plate"/><axis xyz="0 0 1"/>
<limit lower="0" upper="1" effort="1" velocity="1"/></joint></robot>
URDF
rocinante key make lift.key >/dev/null
rocinante key trust lift.key.pub --source lift >trusted.toml
port=$((20000 + $$ % 20000))
printf 't,up\n0,0.4\n300,0.4\n' >table.csv
rocinante source --csv table.csv --device lift --run r --restate 200ms --to "127.0.0.1:$port" --key lift.key --quiet &
source=$!
cat >thief.py <<'PY'
import socket, sys, time
s = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
for i in range(10_000):
    s.sendto(f"RK1 lift@r {1_000_000 + i} -\njoints lift 0.9\n".encode(), ("127.0.0.1", int(sys.argv[1])))
    time.sleep(0.03)
PY
python3 thief.py "$port" &
thief=$!
camera='@3,-3,2/0,0,0.3'
# look NAME [OPTION...]
look() {
  printf 'await 1.5s\npanels off\ncamera %s\nframe 2\nscreenshot %s.png\nsave %s.mcap\nquit\n' "$camera" "$1" "$1" >script.txt
  with_display rocinante view lift.urdf --live "127.0.0.1:$port" --size 320x240 \
    --profile reproducible --script script.txt "${@:2}"
}
look trusting --trust trusted.toml
# Alone from here: each of the two would be the other's restart, and the picture whoever spoke last.
kill $source
look credulous
kill $thief
wait $source $thief 2>/dev/null || true
for height in 0.4 0.9; do
  rocinante render lift.urdf --joints $height --camera "$camera" --size 320x240 -o "$height.png"
done
rocinante golden compare trusting.png 0.4.png
rocinante golden compare credulous.png 0.9.png
rocinante log verify trusting.mcap --trust trusted.toml >verified && echo "all that was kept is trusted"
rocinante log verify credulous.mcap --trust trusted.toml >verified || echo "exit $?"
grep -o 'not signed$' verified
