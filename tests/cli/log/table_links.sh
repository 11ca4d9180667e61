# Poses of links as columns: in the world and in frames, as `model fk` has them.
cat >cell.toml <<'TOML'
format = 1
[[device]]
name = "arm"
model = "arm.urdf"
pose = { xyz = [1, 2, 0], rpy_deg = [0, 0, 30] }
[[device]]
name = "gripper"
model = "arm.urdf"
on = "arm/tool0"
pose = { xyz = [0, 0, 0.125] }
TOML
cat >arm.urdf <<'URDF'
<robot name="arm"><link name="base"/><link name="upper"/><link name="tool0"/>
<joint name="turn" type="revolute"><parent link="base"/><child link="upper"/><axis xyz="0 0 1"/>
<limit lower="-3" upper="3" effort="1" velocity="1"/></joint>
<joint name="bend" type="revolute"><parent link="upper"/><child link="tool0"/><axis xyz="0 1 0"/>
<origin xyz="0.5 0 0.3"/><limit lower="-3" upper="3" effort="1" velocity="1"/></joint></robot>
URDF
rocinante record 127.0.0.1:0 -o log.mcap --cell cell.toml --max-packets 3 >/dev/null 2>said &
until grep -qs '^recording' said; do kill -0 $!; sleep 0.05; done
to="/dev/udp/127.0.0.1/$(sed -n 's/^recording .*:\([0-9]*\) to .*/\1/p' said)"
printf 'RK1 me@a 0 -\njoints arm 0.5 0.25\n' >packet; cat packet >"$to"
printf 'RK1 me@a 1 -\njoint gripper turn=1\n' >packet; cat packet >"$to"
printf 'RK1 me@a 2 -\njoint arm bend=-0.75\n' >packet; cat packet >"$to"
wait $!
rocinante log table log.mcap --link arm/tool0 --device gripper -o table.csv --json
cut -d, -f2-4,6- table.csv
echo "== as fk"
rocinante log table log.mcap --link gripper/tool0 --link arm/base --in gripper/upper -o frame.csv
rocinante log table log.mcap --link gripper/tool0 --link gripper/upper -o world.csv
rocinante model fk cell.toml --log log.mcap --at "$(tail -1 world.csv | cut -d, -f1)s" --json >fk.json
python3 -c '
import csv, json
fk = json.load(open("fk.json"))
last = list(csv.DictReader(open("world.csv")))[-1]
parts = ["x", "y", "z", "qx", "qy", "qz", "qw"]
for link in "gripper/tool0", "gripper/upper":
    said = fk[link]["xyz"] + fk[link]["quaternion"]
    had = [float(last[f"{link}:{part}"]) for part in parts]
    print(link, "the same" if said == had else f"{said} is not {had}")
rows = list(csv.DictReader(open("frame.csv")))
print([name for name in rows[0] if ":x" in name])
print("base seen from the gripper:", [round(float(rows[-1][f"arm/base:{p} in gripper/upper"]), 9) for p in "xyz"])'
echo "== of a device"
rocinante source --csv world.csv --speed 1000 --run r1 --to 127.0.0.1:9 --quiet && echo sent
rocinante log table log.mcap --link arm/tool0 --device gripper -o table.npz
python3 -c 'import zipfile; print(sorted(n for n in zipfile.ZipFile("table.npz").namelist() if "tool0" in n))'
echo "== refused"
try() { rocinante log table "$@" || echo "exit $?"; }
cp "$SRC/tests/data/logs/version-1.mcap" session.mcap
try session.mcap --link arm/tool0
try log.mcap --link arm/tol0
try log.mcap --link amr/tool0
try log.mcap --link arm
try log.mcap --link arm/tool0 --in nothing
try log.mcap --in arm
