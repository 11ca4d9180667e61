# `event_list` holds the first 1,000 events, and every one with --all-events; the count is of all either way.
mkdir datagrams
for i in $(seq 0 14); do
  { echo "RK1 me@a $i -"; for j in $(seq 1 100); do echo "event \"step $((i * 100 + j))\""; done; } >datagrams/$(printf %03d $i).txt
done
rocinante log import datagrams -o session.mcap >/dev/null
rocinante log mark session.mcap 0s last >/dev/null
for option in "" --all-events; do
  rocinante log info --json $option session.mcap >info.json
  python3 -c 'import json; info = json.load(open("info.json")); events = info["event_list"]
print(info["events"], info["marks"], len(events), events[0]["text"], events[-1]["text"])'
done
rocinante log info --all-events session.mcap || echo "exit $?"
