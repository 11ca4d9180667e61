# What a terminal would have said of what is opened is over the picture until it is dismissed: errors of a cell, also when it
# was the argument. A file with nothing to draw does not take the place of a good picture.
export ASAN_OPTIONS=detect_leaks=0
cat >box.urdf <<'URDF'
<robot name="box"><link name="body"><visual><geometry><box size="1 1 1"/></geometry></visual></link></robot>
URDF
printf 'format = 1\n[[devise]]\nname = "a"\nmodel = "box.urdf"\n' >typo.cell.toml
printf 'format = 1\n[[device]]\nname = "a"\nmodel = "box.urdf"\n[[device]]\nname = "b"\nmodel = "gone.urdf"\n' >half.cell.toml
echo 'no model' >words.urdf
cat >script.txt <<'SCRIPT'
panels off
camera @3,-3,2/0,0,0
screenshot before.png
drop typo.cell.toml
await-files
await-line typo.cell.toml is not shown: it has nothing to draw
await-line devise
await-line Esc dismisses it
screenshot noted.png
key escape
await-line
screenshot after.png
drop words.urdf
await-files
await-line words.urdf
key escape
await-line
drop gone.urdf
await-line there is no such file
drop half.cell.toml
await-files
await-line gone.urdf
key escape
await-line
panels off
camera @3,-3,2/0,0,0
screenshot half.png
quit
SCRIPT
view() { with_display rocinante view "$@" --fresh --size 320x240 --samples 1 --profile reproducible 2>&1; }
view box.urdf --script script.txt | sed "s,$PWD/,,g" || echo "exit $?"
rocinante golden compare before.png after.png
rocinante golden compare before.png half.png
rocinante golden compare before.png noted.png --quiet | sed 's/:.*//' || true
printf 'await-line devise\nkey escape\nawait-line\nquit\n' >script.txt
view typo.cell.toml --script script.txt || echo "exit $?"
