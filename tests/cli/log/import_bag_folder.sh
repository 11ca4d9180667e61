# A folder of a ROS 2 bag has the files and as many messages as its metadata.yaml says, or the difference
# is named; a file that it does not list is not read.
mkdir bag
ros2_bag bag/bag_0.db3 3 /arm/joint_states
ros2_bag bag/bag_1.db3 2 /arm/joint_states
metadata() { # BAG FIRST SECOND
  cat >bag/metadata.yaml <<YAML
rosbag2_bagfile_information:
  version: 5
  storage_identifier: sqlite3
  message_count: $1
  topics_with_message_count:
    - topic_metadata:
        name: /arm/joint_states
      message_count: 77
  compression_format: ""
  compression_mode: ""
  relative_file_paths:
    - bag_0.db3
    - bag_1.db3
  files:
    - path: bag_0.db3
      message_count: $2
    - path: bag_1.db3
      message_count: $3
YAML
}
quietly() { rocinante log import bag -o out.mcap --force 2>&1 >/dev/null || echo "exit $?"; }
echo "# as it says"
metadata 5 3 2
quietly
echo "# messages are gone"
metadata 9 3 6
quietly
echo "# there are more"
metadata 4 3 1
quietly
cat >arm.urdf <<'URDF'
<robot name="arm"><link name="base"/><link name="cart"/>
  <joint name="slide" type="prismatic"><parent link="base"/><child link="cart"/>
    <limit lower="-1" upper="1" velocity="1" effort="1"/></joint></robot>
URDF
# Every program that opens the folder says so; what was imported before does not hide it.
rocinante check arm.urdf bag 2>&1 | grep 'should have' || echo "exit $?"
metadata 5 3 2
rocinante check arm.urdf bag 2>&1 | grep -c 'should have' || true
metadata 9 3 6
rocinante check arm.urdf bag 2>&1 | grep 'should have' || echo "exit $?"
echo "# a copy that it does not list"
metadata 5 3 2
cp bag/bag_0.db3 bag/zz_9.db3
quietly
rocinante log info out.mcap --json | grep '"messages"' | sed -n 1p
rm bag/zz_9.db3
echo "# files that were renamed"
mv bag/bag_0.db3 bag/a_0.db3
mv bag/bag_1.db3 bag/a_1.db3
quietly
