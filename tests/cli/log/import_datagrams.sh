# needs: shared
# Three DIS datagrams of real simulators, a file each, become a log that is decoded like a capture; a
# folder that is a ROS 2 bag is imported as one.
mkdir dis
n=1
for file in "$SHARED"/captures/dis_pdus/*.raw; do
  cp "$file" "dis/170000000$n.raw"
  n=$((n + 1))
done
mkdir dis/later
rocinante log import dis -o raw.mcap
rocinante log decode raw.mcap --decoders "$SRC/examples/decoders/dis_entity.decoders.toml" -o decoded.mcap | sed 1d
rocinante log cat raw.mcap --format json | grep -o '"log_time_ns": *[0-9]*\|"topic": *"[^"]*"\|"encoding": *"[^"]*"' | tr -d ' '
rocinante log cat decoded.mcap --channel '/rocinante/decoded/*' | cut -c 1-70
mkdir bag
touch bag/metadata.yaml
ln -s "$SHARED/bags/rosbag2_test_0.db3" bag/
rocinante log import bag -o folder.mcap | sed 1d
rocinante log import "$SHARED/bags/rosbag2_test_0.db3" -o file.mcap >/dev/null
for log in folder file; do rocinante log info $log.mcap --json | grep content_sha256; done | uniq | wc -l
mkdir empty
rocinante log import empty -o no.mcap || echo "exit $?"
