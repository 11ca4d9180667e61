# A force at a link and an emergency stop of a bag are signals that the cell's rules judge.
python3 - <<'PY'
import sqlite3, struct

def padded(body, bytes):
    return body + b"\0" * (-len(body) % bytes)

def string(body, text):
    return padded(body, 4) + struct.pack("<I", len(text) + 1) + text + b"\0"

def header(seconds, frame):
    return string(struct.pack("<iI", seconds, 0), frame)

def wrench(seconds, force):
    return padded(header(seconds, b"tool"), 8) + struct.pack("<6d", force, 0, 0, 0, 0, 0)

def joints(seconds):
    body = padded(header(seconds, b""), 4) + struct.pack("<I", 1)
    body = padded(string(body, b"turn"), 4) + struct.pack("<I", 1)
    return padded(body, 8) + struct.pack("<d", 0.1) + struct.pack("<II", 0, 0)

def diagnostics(seconds, level, load):
    body = padded(header(seconds, b""), 4) + struct.pack("<IB", 1, level)
    for text in (b"arm: motor 1", b"fine", b""):
        body = string(body, text)
    body = string(string(padded(body, 4) + struct.pack("<I", 1), b"load"), load)
    return body

bag = sqlite3.connect("bag.db3")
bag.execute("create table topics(id integer primary key, name, type, serialization_format)")
bag.execute("create table messages(id integer primary key, topic_id, timestamp, data)")
topics = ["/joint_states sensor_msgs/msg/JointState", "/wrench geometry_msgs/msg/WrenchStamped",
          "/estop std_msgs/msg/Bool", "/diagnostics diagnostic_msgs/msg/DiagnosticArray"]
for i, topic in enumerate(topics):
    bag.execute("insert into topics values(?, ?, ?, 'cdr')", (i + 1, *topic.split()))
first = 1700000000
for i in range(3):
    messages = [joints(first + i), wrench(first + i, 10.0 * i), bytes([i == 2]),
                diagnostics(first + i, i, b"nan" if i == 1 else b"0.5")]
    for topic, message in enumerate(messages):
        row = (topic + 1, (first + i) * 10**9 + topic, b"\0\1\0\0" + message)
        bag.execute("insert into messages(topic_id, timestamp, data) values(?, ?, ?)", row)
bag.commit()
PY
cat >arm.urdf <<'X'
<robot name="arm"> <link name="base"/> <link name="tool"/>
  <joint name="turn" type="revolute"> <parent link="base"/> <child link="tool"/>
  <axis xyz="0 0 1"/> <limit lower="-1" upper="1" effort="1" velocity="9"/> </joint> </robot>
X
cat >arm.cell.toml <<'X'
format = 1
[[device]]
name = "arm"
model = "arm.urdf"
[[signal]]
path = "arm/tool"
name = "wrench.force.x"
unit = "N"
range = [-15, 15]
[[signal]]
path = "-"
name = "estop"
values = ["false"]
X
rocinante log import bag.db3 --cell arm.cell.toml -o log.mcap
rocinante log cat log.mcap --channel '/rocinante/decoded/*'
rocinante log state log.mcap --at 2s | sed -n '/signals (/,$p'
# The version of the translation lies with the packets.
rocinante log info log.mcap --json | grep -A 12 '"/rocinante/decoded/estop"' | grep decoder
rocinante check arm.cell.toml bag.db3 || echo "exit $?"
