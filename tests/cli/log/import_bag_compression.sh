# A bag whose metadata.yaml names a compression of messages that is not read: by what the messages are.
mkdir plain packed
ros2_bag plain/bag_0.db3 3 /arm/joint_states
ros2_bag packed/bag_0.db3 3 /arm/joint_states
python3 - <<'PY'
import sqlite3
base = sqlite3.connect("packed/bag_0.db3")
base.execute("update messages set data = x'6c7a39' where rowid > 1")
base.commit()
PY
for bag in plain packed; do
  printf 'rosbag2_bagfile_information:\n  compression_format: "lz9"\n  compression_mode: "MESSAGE"\n' >$bag/metadata.yaml
  rocinante log import $bag -o $bag.mcap || echo "exit $?"
done
# What else reads logs points there, as for the file of a bag.
rocinante log info plain || echo "exit $?"
rocinante log cut plain --from 0s -o cut.mcap || echo "exit $?"
mkdir other
rocinante log info other || echo "exit $?"
