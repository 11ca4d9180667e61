# needs: shared
# Bags of both versions of ROS become logs that can be read, cut and checked, and that keep every message.
bags=$SHARED/bags
rocinante log import "$bags/rosbag2_test_0.db3" -o pose.mcap
rocinante log import "$bags/fake_joint_state.bag" -o joints.mcap --device arm
rocinante log import "$bags/multiple_files_1.mcap" "$bags/topics_and_services.db3" -o both.mcap
sizes() { sed "s/, [0-9]* bytes)/)/"; }
rocinante log doctor pose.mcap joints.mcap both.mcap | sizes
rocinante log cat joints.mcap --channel '/rocinante/decoded/*' --until 0.001s
rocinante log state joints.mcap --at 2s
# A part of it keeps the schemas.
rocinante log cut joints.mcap --from 1s --until 2s -o part.mcap
rocinante log doctor part.mcap | sizes
grep -c 'float64\[\] position' joints.mcap part.mcap || true
