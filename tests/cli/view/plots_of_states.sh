# States are bands with their texts, numbers curves with the limits of the cell, in the plots; what no
# packet states is refused with the names that the log has.
export ASAN_OPTIONS=detect_leaks=0
cat >arm.urdf <<'URDF'
<robot name="arm"><link name="base"><visual><geometry><box size="0.3 0.3 0.2"/></geometry></visual></link>
<link name="hand"><visual><geometry><box size="0.1 0.1 0.6"/></geometry><origin xyz="0 0 0.3"/></visual></link>
<joint name="bend" type="revolute"><parent link="base"/><child link="hand"/><axis xyz="0 1 0"/>
<limit lower="-1.2" upper="1.2" effort="1" velocity="1"/></joint></robot>
URDF
cat >cell.toml <<'TOML'
format = 1
[[device]]
name = "arm"
model = "arm.urdf"
[[signal]]
path = "arm"
name = "load"
unit = "kg"
range = [0, 6]
TOML
packets=$(python3 -c '
import math
for i in range(200):
    t = i * 50
    said = [f"RK1 arm@a {i} -", f"joints arm {1.1 * math.sin(i / 20):.4f}",
            f"signal arm load {3 + 3.4 * math.sin(i / 30):.3f} kg", f"signal arm/hand force {i % 40 / 4} N"]
    mode = "idle" if i < 30 else "auto" if i < 110 else "fault: the gripper does not close" if i < 140 else "manual"
    if i % 10 == 0 or i in (110, 140): said.append(f"signal arm mode \"{mode}\"")
    if i in (70, 71, 72): said.append("signal arm mode \"" + ("hold", "stop", "auto")[i - 70] + "\"")
    said.append("signal - estop " + ("true" if 110 <= i < 125 else "false"))
    print(f"{t}:whole:" + "\\n".join(said) + "\\n")')
mapfile -t lines <<<"$packets"
make_pcap s.pcap "${lines[@]}"
rocinante log import s.pcap -o s.mcap --cell cell.toml
cat >plots.script <<'SCRIPT'
select arm
plot signal arm mode
plot signal - estop
plot signal arm load
plot arm.bend
plot arm/hand:qy
seek 6s
frame 2
screenshot dark.png
plots off
frame 2
screenshot none.png
plots on
theme light
frame 2
screenshot light.png
unplot all
plot d/dt arm.bend
plot mean 0.5 d/dt arm/hand:qy
plot signal arm load - signal arm/hand force
plot d/dt signal arm load
plot arm.bend
frame 2
screenshot derived.png
SCRIPT
show() {
  with_display rocinante view cell.toml s.mcap --size 1000x640 --samples 1 --profile reproducible --script "$1"
}
cat >paths.script <<'SCRIPT'
plot arm.bend over arm/hand:qy
plot d/dt arm.bend over signal arm load
seek 6s
frame 2
screenshot paths.png
plot signal arm load
frame 2
screenshot both.png
SCRIPT
show plots.script
show paths.script
for other in none light derived paths both; do
  rocinante golden compare dark.png $other.png --quiet >/dev/null || echo "plots are not as in $other.png"
done
for wrong in 'signal arm mood' 'signal amr mode' 'arm.bent' 'arm/hnad:z' 'd/dt arm.bent' \
  'mean nan arm.bend' 'd/dt signal arm mode' 'rate over arm.bend' 'signal arm mode over arm.bend'; do
  echo "plot $wrong" >wrong.script
  show wrong.script || echo "exit $?"
done
