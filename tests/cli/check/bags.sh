# A ROS 2 bag is checked against a cell, and the cell against the robot that the bag describes.
cp -r "$SRC/examples/demo" demo && cd demo
check() { rocinante check "$@" --quiet && echo fits || echo "exit $?"; }
rocinante log export motion.mcap demo.cell.toml --ros2 -o bag.mcap >/dev/null
check demo.cell.toml bag.mcap
cat >arm.urdf <<'URDF'
<robot name="arm">
  <link name="base"/> <link name="upper"/>
  <joint name="shoulder" type="revolute"> <parent link="base"/> <child link="upper"/>
    <axis xyz="0 0 1"/> <limit lower="-2" upper="2" effort="1" velocity="9"/> </joint>
</robot>
URDF
python3 - <<'PY'
# A log of one device, to be exported with its cell.
with open("motion.csv", "w") as table:
    table.write("t,arm.shoulder\n")
    for i in range(20):
        table.write(f"{i / 100},{i / 100}\n")
PY
rocinante log import motion.csv --cell arm.urdf -o arm.mcap >/dev/null
rocinante log export arm.mcap arm.urdf --ros2 -o arm_bag.mcap >/dev/null || true
check arm.urdf arm_bag.mcap
check arm_bag.mcap
sed 's/upper="2"/upper="1"/; s/xyz="0 0 1"/xyz="0 1 0"/' arm.urdf >other.urdf
rocinante check other.urdf arm_bag.mcap && echo fits || echo "exit $?"
