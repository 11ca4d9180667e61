# Meshes a thousand times too small and too large are held against what the joints reach.
printf 'v 0 0 0\nv 0.3 0 0\nv 0 0.3 0\nf 1 2 3\n' >part.obj
arm() {
  echo '<robot name="arm">'
  for link in a b c d; do
    echo "<link name=\"$link\"><visual><geometry><mesh filename=\"part.obj\" scale=\"$1 $1 $1\"/></geometry></visual></link>"
  done
  for pair in "a b" "b c" "c d"; do
    set -- $pair
    echo "<joint name=\"$1$2\" type=\"revolute\"><parent link=\"$1\"/><child link=\"$2\"/><origin xyz=\"0 0 0.5\"/>"
    echo '<axis xyz="0 0 1"/><limit lower="-2" upper="2" effort="1" velocity="1"/></joint>'
  done
  echo '</robot>'
}
for scale in 0.001 1 1000; do
  arm $scale >arm.urdf
  rocinante check arm.urdf --strict | grep -v '^$' || echo "exit $?"
done
