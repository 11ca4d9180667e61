# A folder that is a ROS 2 bag is a recording, no other is.
cp -r "$SRC/examples/demo" demo && cd demo
rocinante log export motion.mcap demo.cell.toml --ros2 -o bag.mcap >/dev/null 2>&1
mkdir bag && mv bag.mcap bag/bag_0.mcap && touch bag/metadata.yaml
rocinante check demo.cell.toml bag --quiet && echo fits || echo "exit $?"
rocinante check demo.cell.toml bag/ | sed -n 1p
ls -A bag "$XDG_CACHE_HOME"/rocinante/imports | sed -E "s#$XDG_CACHE_HOME#CACHE#; s/^[0-9a-f]{64}/KEY/"
ls -d .rocinante 2>/dev/null || echo "nothing beside it"
rocinante render demo.cell.toml bag/bag_0.mcap --at 5 --size 160x120 --samples 1 --hash 2>/dev/null >file
rocinante render demo.cell.toml bag --at 5 --size 160x120 --samples 1 --hash 2>/dev/null >folder
cmp file folder && echo "the same picture"
# Without a cell, the robot that the bag describes.
cat >arm.urdf <<'URDF'
<robot name="arm">
  <link name="base"/> <link name="upper"/>
  <joint name="shoulder" type="revolute"> <parent link="base"/> <child link="upper"/>
    <axis xyz="0 0 1"/> <limit lower="-2" upper="2" effort="1" velocity="9"/> </joint>
</robot>
URDF
printf 't,shoulder\n0,0\n0.1,0.1\n' >motion.csv
rocinante log import motion.csv --cell arm.urdf -o arm.mcap >/dev/null
mkdir robot && touch robot/metadata.yaml
rocinante log export arm.mcap arm.urdf --ros2 -o robot/arm_0.mcap >/dev/null 2>&1 || true
rocinante check robot | tail -n 1
# What is none of them.
check() { rocinante check "$@" || echo "exit $?"; }
mkdir none logs packed raw && cp arm.mcap logs && touch packed/metadata.yaml packed/bag_0.db3.zstd
check arm.urdf none
check arm.urdf logs
check arm.urdf packed
check raw
