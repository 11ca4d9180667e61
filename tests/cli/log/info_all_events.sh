# `event_list` holds the first 1,000 events, and every one with --all-events; the count is of all either way.
python3 - "$SRC/tests/support" <<'PY'
import sys
sys.path.insert(0, sys.argv[1])
from udp_capture import write_capture
events = lambda i: "".join(f'event "step {i * 100 + j}"\n' for j in range(1, 101))
write_capture("traffic.pcap", [(i, f"RK1 me@a {i} -\n{events(i)}".encode(), 5000) for i in range(15)], 19960)
PY
rocinante log import traffic.pcap -o session.mcap >/dev/null
rocinante log mark session.mcap 0s last >/dev/null
for option in "" --all-events; do
  rocinante log info --json $option session.mcap >info.json
  python3 -c 'import json; info = json.load(open("info.json")); events = info["event_list"]
print(info["events"], info["marks"], len(events), events[0]["text"], events[-1]["text"])'
done
rocinante log info --all-events session.mcap || echo "exit $?"
