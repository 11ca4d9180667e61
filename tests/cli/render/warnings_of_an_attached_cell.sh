# What is wrong inside an attached cell has the attachment's name, not by where it lay for a moment.
cat >tank.obj <<'OBJ'
mtllib tank.mtl
v 0 0 0
v 1 0 0
v 0 1 0
vt 0 0
usemtl skin
f 1/1 2/1 3/1
OBJ
printf 'newmtl skin\nmap_Kd skin.png\n' >tank.mtl
printf 'no picture' >skin.png
rocinante record 127.0.0.1:0 --cell tank.obj -o session.mcap --duration 50ms --quiet
rocinante render session.mcap --at 0 -o frame.png 2>&1 | sed 's/: [^:]* (session/: WHY (session/'
printf 'usemtl gone\nf 1 2 9\n' >>tank.obj
rocinante record 127.0.0.1:0 --cell tank.obj -o other.mcap --duration 50ms --quiet || echo "exit $?"
