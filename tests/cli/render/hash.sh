# One line a frame; the same whatever the environment says; --json tells the same.
cat > box.urdf <<'URDF'
<robot name="box"><link name="body"><visual><geometry><box size="1 1 1"/></geometry>
<material name="red"><color rgba="1 0 0 1"/></material></visual></link></robot>
URDF
plain=$(rocinante-render box.urdf --hash --size 160x120)
test ${#plain} -eq 64
other=$(LP_NATIVE_VECTOR_WIDTH=256 GALLIUM_DRIVER=softpipe LC_ALL=de_DE.UTF-8 TZ=Asia/Tokyo \
  rocinante-render box.urdf --hash --size 160x120)
test "$plain" = "$other"
rocinante-render box.urdf --json --size 160x120 -o box.png | sed "s/$plain/HASH/; s/llvmpipe-[^ \"]*/KEY/; s/\"inputs\": \"[0-9a-f]*\"/\"inputs\": \"INPUTS\"/"
head -c 4 box.png | tail -c 3; echo
hidden=$(rocinante-render box.urdf --hash --size 160x120 --hide box)
test "$plain" != "$hidden"
one=$(rocinante-render box.urdf --hash --size 160x120 --samples 1)
test "$plain" != "$one"
