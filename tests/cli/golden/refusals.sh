# What cannot be judged is never yes: exit 2 and one sentence with its place.
cat >box.urdf <<'URDF'
<robot name="box"><link name="body"><visual><geometry><box size="1 1 1"/></geometry></visual></link></robot>
URDF
printf 'format = 1\ncell = "box.urdf"\n[[case]]\nname = "a"\nsize = [64, 48]\n' >suite.toml
try() { rocinante golden "$@" 2>&1 || echo "exit $?"; }
try run missing.toml
try run suite.toml --only nothing
try run suite.toml --cell missing.urdf
try run suite.toml --log missing.mcap
printf 'format = 1\ncell = "box.urdf"\n[[case]]\nname = "a"\nsized = 3\n' >bad.toml
try run bad.toml
printf 'format = 1\ncell = "box.urdf"\n[[case]]\nname = "a"\nat = "3s"\n' >moment.toml
try run moment.toml
printf 'format = 1\ncell = "box.urdf"\n[[case]]\nname = "a"\ncamera = "lid"\n' >camera.toml
try run camera.toml
try approve camera.toml -m why
ls
