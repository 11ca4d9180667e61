# A sqlite3 bag that is cut anywhere is refused with a sentence, or read as far as it goes.
python3 - <<'PY'
import sqlite3
base = sqlite3.connect("bag.db3")
base.execute("create table topics(id integer primary key, name, type, serialization_format)")
base.execute("create table messages(id integer primary key, topic_id, timestamp, data)")
base.execute("create index by_time on messages(timestamp)")
base.execute("insert into topics values(1, '/camera', 'sensor_msgs/msg/Image', 'cdr')")
for i in range(40):
    base.execute("insert into messages values(?, 1, ?, ?)", (i, i * 10, bytes(400)))
base.commit()
base.close()
PY
size=$(stat -c %s bag.db3)
wrong=0 refused=0 partly=0
for bytes in 0 1 15 16 50 99 100 $(seq 512 1021 $((size - 1))); do
  head -c "$bytes" bag.db3 >cut.db3
  code=0
  rocinante log import cut.db3 -o cut.mcap --force >out 2>said || code=$?
  case $code in
    2) refused=$((refused + 1)) ;;
    1) partly=$((partly + 1)) ;;
    *) wrong=$((wrong + 1)); echo "$bytes bytes: exit $code" ;;
  esac
  [ "$(grep -c '^rocinante-log: ' said)" -ge 1 ] || echo "$bytes bytes: not a word"
done
[ $((refused > 0 && partly > 0)) = 1 ] && echo "refused, or read in part: all"
rocinante log import bag.db3 -o whole.mcap
