# What the finding of two topics of one robot prints can be followed as it stands.
cat >arm.urdf <<'URDF'
<robot name="arm"><link name="base"/><link name="cart"/>
  <joint name="slide" type="prismatic"><parent link="base"/><child link="cart"/>
    <limit lower="-1" upper="1" velocity="1" effort="1"/></joint></robot>
URDF
ros2_bag two.db3 20 /joint_states /joint_states_desired
rocinante check arm.urdf two.db3 >found.txt || echo "exit $?"
grep -E 'two-sources|hint' found.txt
hint=$(sed -n 's/.*hint: //p' found.txt)
follow() { # COMMAND: with the names that it leaves open
  local words=${1//FILE/two.db3}
  words=${words//CELL/arm.urdf} words=${words//LOG/two.mcap}
  echo "$ ${words//OUT/one.mcap}"
  eval "${words//OUT/one.mcap}"
}
follow "rocinante${hint##*: rocinante}"
filter=${hint#*: }
follow "${filter%%;*}"
rocinante check arm.urdf one.mcap | grep -v '^one' || echo "exit $?"
