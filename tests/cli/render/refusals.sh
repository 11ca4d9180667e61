# What cannot be done ends with exit 2 and one sentence, and leaves nothing behind.
cat > box.urdf <<'URDF'
<robot name="box"><link name="body"><visual><geometry><box size="1 1 1"/></geometry></visual></link></robot>
URDF
try() { rocinante-render "$@" 2>&1 && echo "exit 0" || echo "exit $?"; }
try box.urdf
try box.urdf --at 3 --hash
try box.urdf no-such.mcap --at 3 --hash | sed 's/: [A-Z].*no-such/: ... no-such/'
try no-such.urdf --hash
try box.urdf --hash --size 0x480
try box.urdf --hash --size 640
try box.urdf --hash --samples 3
try box.urdf --hash --camera lid
try box.urdf --hash --hide layer
try box.urdf -o box
try box.urdf --hash --frame-type jpg
(export ROCINANTE_MODULES=/nowhere; try box.urdf -o box.jpg)
try box.urdf --hash --profile pretty
try box.urdf --shadows on --hash --shading plain
rocinante-render box.urdf -o box.png --size 64x48
try box.urdf -o box.png --size 64x48
try box.urdf -o box.png --size 64x48 --force
ls
