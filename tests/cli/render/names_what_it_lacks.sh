# What the picture lacks is named, whatever the format; a mesh that is not there makes it incomplete.
draw() { rocinante render "$1" --size 64x48 --hash >/dev/null || echo "$1: exit $?"; }
for mesh in '<mesh/>' '<mesh filename=""/>' '<mesh filename="none.stl"/>'; do
  echo "<robot name='r'><link name='l'><visual><geometry>$mesh</geometry></visual></link></robot>" >r.urdf
  draw r.urdf
done
printf 'solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n' >cut.stl
draw cut.stl
cat >lost.dae <<'DAE'
<COLLADA version="1.4.1"><asset><up_axis>Z_UP</up_axis></asset>
<library_visual_scenes><visual_scene id="s"><node>
<instance_geometry url="other.dae#g"/></node></visual_scene></library_visual_scenes>
<scene><instance_visual_scene url="#s"/></scene></COLLADA>
DAE
draw lost.dae
echo "<robot name='r'><link name='l'><visual><geometry><mesh filename='lost.dae'/></geometry></visual></link></robot>" >lost.urdf
draw lost.urdf
