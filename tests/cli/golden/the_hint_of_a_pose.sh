# The hint for the stated pose of a device accepts that pose, position and turn, and judges no link by itself.
export ROCINANTE_USER=ada XDG_CACHE_HOME=$PWD/cache
cat >arm.urdf <<'URDF'
<robot name="arm"><link name="base"/><link name="hand"/>
<joint name="turn" type="revolute"><parent link="base"/><child link="hand"/><axis xyz="0 0 1"/>
<limit lower="-2" upper="2" effort="9" velocity="9"/></joint></robot>
URDF
printf 'format = 1\n[[device]]\nmodel = "arm.urdf"\n' >cell.toml
suite() { printf 'format = 1\ncell = "cell.toml"\n[[run]]\nname = "stand"\nalign = "origin"\nlimits = { %s }\n' "$1" >runs.toml; }
for i in $(seq 100 199); do echo "$i.0 1 2 0 0 0 0 1"; done | sed "1i # timestamp tx ty tz qx qy qz qw" >before.txt
sed 's/ 1 2 0 0 0 0 1/ 1.004 2 0 0 0 0.0087 0.99996/' before.txt >now.txt
for log in before now; do rocinante log import $log.txt --device arm -o $log.mcap >made.txt; done
suite ''
rocinante golden approve runs.toml --run stand -m first --log before.mcap --anyway >made.txt 2>&1
run() { rocinante golden run runs.toml --log now.mcap --json out.json || echo "exit $?"; }
items() { python3 -c 'import json; run = json.load(open("out.json"))["runs"][0]; print(run["items"], run["coverage"]["judged"])'; }
run
items
suite "$(python3 -c 'import json; print(", ".join(f["accept"] for f in json.load(open("out.json"))["runs"][0]["findings"][:1]))')"
run
suite '"arm" = { pose_mm = 4.1, pose_deg = 1.1 }'
run
items
echo "-- limits of positions hold for it, too"
suite '"arm" = { position_mm = 4.1, turn_deg = 1.1 }'
run
suite '"arm" = { pose_mm = 0.1, pose = 1 }'
run
