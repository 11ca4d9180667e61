# Joints moved in a window without a log: a script's picture is the one that render draws of the same --joints, mimic joints
# follow, and what the window drives is an ordinary source that a recorder keeps.
export ASAN_OPTIONS=detect_leaks=0
cat >lift.urdf <<'URDF'
<robot name="lift"><link name="base"><visual><geometry><box size="1 1 0.2"/></geometry></visual></link>
<link name="plate"><visual><geometry><box size="0.6 0.6 0.1"/></geometry></visual></link>
<link name="arm"><visual><origin xyz="0.4 0 0.1"/><geometry><box size="0.8 0.1 0.1"/></geometry></visual></link>
<link name="stop"><visual><geometry><box size="0.1 0.1 0.3"/></geometry></visual></link>
<joint name="up" type="prismatic"><parent link="base"/><child link="plate"/><axis xyz="0 0 1"/>
<limit lower="0" upper="1" effort="1" velocity="1"/></joint>
<joint name="turn" type="continuous"><parent link="plate"/><child link="arm"/><axis xyz="0 0 1"/></joint>
<joint name="side" type="prismatic"><parent link="base"/><child link="stop"/><axis xyz="1 0 0"/>
<limit lower="0" upper="1" effort="1" velocity="1"/><mimic joint="up" multiplier="0.5"/></joint></robot>
URDF
rocinante record 127.0.0.1:0 -o driven.mcap >/dev/null 2>said &
recorder=$!
until grep -qs '^recording' said; do kill -0 $recorder; sleep 0.05; done
port=$(sed 's/.*:\([0-9]*\) to .*/\1/' said)
cat >script.txt <<SCRIPT
panels off
camera @3,-3,2/0,0,0.3
drive 127.0.0.1:$port,me
joint lift/up 300mm
joint lift/turn 30deg
frame 2
joints lift 0.4,0.5
frame 8
drive off
frame 2
screenshot window.png
evidence evidence.png
reset all
frame 2
screenshot rest.png
quit
SCRIPT
with_display rocinante view lift.urdf --size 320x240 --profile reproducible --script script.txt
kill -INT $recorder
wait $recorder
rocinante render lift.urdf --joints '0.4 0.5' --camera @3,-3,2/0,0,0.3 --size 320x240 -o render.png
rocinante render lift.urdf --camera @3,-3,2/0,0,0.3 --size 320x240 -o home.png
rocinante golden compare window.png render.png
rocinante golden compare evidence.png render.png
rocinante golden compare rest.png home.png
rocinante golden compare rest.png render.png --quiet | sed 's/:.*//' || true
rocinante log cat driven.mcap | grep -o 'joint lift .*' | awk '!seen[$0]++'
rocinante log cat driven.mcap | grep -o 'RK1 me@' | sort -u
