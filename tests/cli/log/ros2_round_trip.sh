# A log that left as a ROS 2 bag comes back with the same values, order and nanoseconds.
demo=$SRC/examples/demo
rocinante log export "$demo/motion.mcap" "$demo/demo.cell.toml" --ros2 -o bag.mcap >/dev/null
rocinante log import bag.mcap --cell "$demo/demo.cell.toml" -o back.mcap >/dev/null
for log in "$demo/motion.mcap" back.mcap; do
  rocinante log table "$log" --cell "$demo/demo.cell.toml" --changes -o "$(basename "$log" .mcap).csv" >/dev/null
done
python3 - <<'PY'
import csv
def table(name):
    rows = list(csv.DictReader(open(name)))
    return {row["t"]: row for row in rows}
before, after = table("motion.csv"), table("back.csv")
joints = [name for name in next(iter(before.values())) if "." in name and name in next(iter(after.values()))]
worst = differing = compared = 0
for time, row in after.items():
    if time not in before:
        continue
    compared += 1
    for joint in joints:
        if before[time][joint] and row[joint] and before[time][joint] != row[joint]:
            differing += 1
print(len(joints), "joints;", "rows with equal times:", "all" if compared == len(after) else compared, "; values that differ:", differing)
PY
