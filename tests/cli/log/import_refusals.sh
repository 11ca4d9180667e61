# What cannot be imported is refused with a sentence, and nothing is made.
try() { rocinante log import "$@" -o out.mcap && echo made || echo "exit $?"; }
printf 'RK1 a 1 -' >text.txt
printf '#ROSBAG V2.0\n' >short.bag
printf '\xd4\xc3\xb2\xa1 a capture' >traffic.pcap
printf 'SQLite format 3\0 and no more' >none.db3
: >empty.mcap
try text.txt
try short.bag
try traffic.pcap
try none.db3
try empty.mcap
try missing.mcap
try short.bag --cell missing.toml
python3 - <<'PY'
import sqlite3
tables = {
    "no_topics": ["create table messages(id integer primary key, topic_id, timestamp, data)"],
    "no_column": ["create table topics(id integer primary key, name)", "create table messages(id)"],
    "no_messages": ["create table topics(id integer primary key, name, type, serialization_format)"],
    "empty": ["create table topics(id integer primary key, name, type, serialization_format)",
              "create table messages(id integer primary key, topic_id, timestamp, data)"],
    # A view could have rows without end.
    "view": ["create table topics(id integer primary key, name, type, serialization_format)",
             "create view messages as with recursive n(x) as (select 1 union all select x + 1 from n) "
             "select x as id, 1 as topic_id, x as timestamp, zeroblob(10) as data from n"],
    # Values of other types than rosbag2 writes.
    "odd": ["create table topics(id integer primary key, name, type, serialization_format)",
            "create table messages(id integer primary key, topic_id, timestamp, data)",
            "insert into topics values(1, '/joint_states', 'sensor_msgs/msg/JointState', 'cdr')",
            "insert into topics values(2, null, x'00', 7)",
            "insert into messages values(1, 1, 10, null)",
            "insert into messages values(2, 1, 'soon', 'text')",
            "insert into messages values(3, 2, 20, 5)",
            "insert into messages values(4, 9, 30, x'00')",
            "insert into messages values(5, 1, -5, x'00010000')",
            "insert into messages values(6, 1, 40, x'00010000ffffffffffffffffffffffff')"],
}
for name, commands in tables.items():
    base = sqlite3.connect(name + ".db3")
    for command in commands:
        base.execute(command)
    base.commit()
    base.close()
PY
for name in no_topics no_column no_messages empty view odd; do try $name.db3; done
ls *.mcap
