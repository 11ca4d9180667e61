# needs: shared
rocinante log import --help | sed -n 1,4p
rocinante log import "$SHARED/bags/rosbag2_test_0.db3" -o pose.mcap --json | grep -v '"bytes"'
rocinante log import "$SHARED/bags/rosbag2_test_0.db3" -o pose.mcap || echo "exit $?"
rocinante log import pose.mcap -o again.mcap || echo "exit $?"
