# The robot of a bag's robot_description is the log's cell, also where none of its meshes is found.
python3 - <<'PY'
import sqlite3, struct

def padded(body, bytes):
    return body + b"\0" * (-len(body) % bytes)

def string(body, text):
    return padded(body, 4) + struct.pack("<I", len(text) + 1) + text + b"\0"

def joint_state(position):
    body = padded(string(struct.pack("<iI", 1, 0), b""), 4) + struct.pack("<I", 1)
    body = padded(string(body, b"turn"), 4) + struct.pack("<I", 1)
    body = padded(body, 8) + struct.pack("<d", position) + struct.pack("<II", 0, 0)
    return b"\0\1\0\0" + body

urdf = b"""<robot name="arm"> <link name="base"> <visual> <geometry>
  <mesh filename="package://their_workspace/meshes/base.stl"/> </geometry> </visual> </link>
  <link name="tip"> <visual> <geometry> <box size="1 1 1"/> </geometry> </visual> </link>
  <joint name="turn" type="revolute"> <parent link="base"/> <child link="tip"/>
  <axis xyz="0 0 1"/> <limit lower="-1" upper="1" effort="1" velocity="9"/> </joint> </robot>"""
bag = sqlite3.connect("bag.db3")
bag.execute("create table topics(id integer primary key, name, type, serialization_format)")
bag.execute("create table messages(id integer primary key, topic_id, timestamp, data)")
bag.execute("insert into topics values(1, '/joint_states', 'sensor_msgs/msg/JointState', 'cdr')")
bag.execute("insert into topics values(2, '/robot_description', 'std_msgs/msg/String', 'cdr')")
first = 1700000000 * 10**9
bag.execute("insert into messages values(1, 2, ?, ?)", (first, b"\0\1\0\0" + string(b"", urdf)))
for i in range(5):
    row = (i + 2, first + i * 10**8, joint_state(0.4 * i))
    bag.execute("insert into messages values(?, 1, ?, ?)", row)
bag.commit()
PY
rocinante log import bag.db3 -o log.mcap 2>&1 || echo "exit $?"
rocinante check bag.db3 | sed 's#/tmp/[^ ]*/#.../#' || echo "exit $?"
rocinante log table log.mcap -o table.csv && tail -n 1 table.csv
