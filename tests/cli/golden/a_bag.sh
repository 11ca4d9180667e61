# A suite's log may be a bag: it is imported, and its frames are those of the log made of it.
cp -r "$SRC/examples/demo" demo && cd demo
rocinante log export motion.mcap demo.cell.toml --ros2 -o bag.mcap >/dev/null 2>&1
cat >bag.suite.toml <<'TOML'
format = 1
cell = "demo.cell.toml"
log = "bag.mcap"

[[case]]
name = "middle"
at = "5s"
size = [160, 120]
TOML
ROCINANTE_USER=ada rocinante golden approve bag.suite.toml -m first >/dev/null 2>said || { echo "exit $?"; cat said; }
rocinante golden run bag.suite.toml >out 2>said && tail -n 1 out || { echo "exit $?"; cat out said; }
rocinante log import bag.mcap --cell demo.cell.toml -o imported.mcap >/dev/null 2>&1
rocinante golden run bag.suite.toml --log imported.mcap >out 2>said && tail -n 1 out || { echo "exit $?"; cat out said; }
