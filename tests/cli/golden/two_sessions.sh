# Two recordings of one scenario: the same, or where they part; and the first moment that shows it.
cp "$SRC/examples/demo/session.mcap" .
session=session.mcap cell=$SRC/examples/demo/demo.cell.toml
rocinante golden session "$session" "$session" "$cell" --no-pictures
rocinante log cut "$session" --until 10s -o first.mcap >made.txt
rocinante golden session "$session" first.mcap "$cell" --no-pictures || echo "exit $?"
rocinante log filter "$session" --source arm --source planner -o still.mcap >made.txt
rocinante golden session "$session" still.mcap "$cell" --no-pictures --json >answer.json || echo "exit $?"
python3 -c 'import json; a = json.load(open("answer.json")); print(a["format"], a["verdict"])'
rocinante golden bisect "$session" "$cell" --other-log "$session"
rocinante golden bisect "$session" "$cell" --other-log still.mcap || echo "exit $?"
rocinante golden session "$session" "$session" "$cell" --no-pictures --align warp --event-ms 100 | tail -1
rocinante golden session "$session" "$session" "$cell" --joint-deg 0.01 || echo "exit $?"
rocinante golden session "$session" "$session" "$cell" --align time || echo "exit $?"
rocinante golden session "$session" nowhere.mcap || echo "exit $?"
rocinante golden bisect "$session" "$cell" || echo "exit $?"
