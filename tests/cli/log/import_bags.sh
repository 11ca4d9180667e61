# needs: shared
# Bags of others.
. "$SRC/tests/support/blocks.sh"

# A folder that is a ROS 2 bag is imported as one; any other is refused with what is taken.
block "import folders"
mkdir bag
touch bag/metadata.yaml
ln -s "$SHARED/bags/rosbag2_test_0.db3" bag/
rocinante log import bag -o folder.mcap | sed 1d
rocinante log import "$SHARED/bags/rosbag2_test_0.db3" -o file.mcap >/dev/null
for log in folder file; do rocinante log info $log.mcap --json | grep content_sha256; done | uniq | wc -l
mkdir empty raw
printf 'RK1 a@b 1 -\njoints arm 0.5\n' >raw/1700000001.txt
for folder in empty raw; do rocinante log import $folder -o no.mcap || echo "exit $?"; done
rocinante play raw --to udp://127.0.0.1:9 || echo "exit $?"

block "import help and json"
rocinante log import --help | sed -n 1,4p
rocinante log import "$SHARED/bags/rosbag2_test_0.db3" -o pose.mcap --json | grep -v '"bytes"'
rocinante log import "$SHARED/bags/rosbag2_test_0.db3" -o pose.mcap || echo "exit $?"
rocinante log import pose.mcap -o again.mcap || echo "exit $?"
