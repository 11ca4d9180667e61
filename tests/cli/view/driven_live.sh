# In a live session packets alone move the picture: what the window drives comes back as any other source's, and then shows;
# without driving, a joint cannot be moved by hand.
export ASAN_OPTIONS=detect_leaks=0
cat >lift.urdf <<'URDF'
<robot name="lift"><link name="base"><visual><geometry><box size="1 1 0.2"/></geometry></visual></link>
<link name="plate"><visual><geometry><box size="0.6 0.6 0.1"/></geometry></visual></link>
<joint name="up" type="prismatic"><parent link="base"/><child link="plate"/><axis xyz="0 0 1"/>
<limit lower="0" upper="1" effort="1" velocity="1"/></joint></robot>
URDF
cat >script.txt <<'SCRIPT'
panels off
camera @3,-3,2/0,0,0.3
joint lift/up 400mm
wait 3
drive off
frame 2
screenshot window.png
quit
SCRIPT
with_display rocinante view lift.urdf --live 127.0.0.1:29986 --drive 127.0.0.1:29986 --as me \
  --size 320x240 --profile reproducible --script script.txt
rocinante render lift.urdf --joints 0.4 --camera @3,-3,2/0,0,0.3 --size 320x240 -o render.png
rocinante golden compare window.png render.png
printf 'joint lift/up 1\nquit\n' >script.txt
with_display rocinante view lift.urdf --live 127.0.0.1:29986 --size 320x240 --script script.txt 2>&1 ||
  echo "exit $?"
