# A piece of a recording whose next piece is not there: check, render and golden say so, and check's verdict is the same.
printf '<robot name="arm"><link name="base"/><link name="hand"/><joint name="j" type="continuous"><parent link="base"/><child link="hand"/></joint></robot>' >puma.urdf
printf 'format = 1\n[[device]]\nname = "puma"\nmodel = "puma.urdf"\n[[camera]]\nname = "c"\neye = [2, 2, 2]\ntarget = [0, 0, 0]\n' >cell.toml
say() {
  printf 'RK1 arm@run %s 5.5\njoints puma %s\n' "$1" "$1" >datagram
  cat datagram >/dev/udp/127.0.0.1/"$port"
  sleep 0.05
}
rocinante record 127.0.0.1:0 -o 'p-%n.mcap' --split-time 1ms --max-packets 3 >said.out 2>said &
until grep -qs '^recording' said; do sleep 0.05; done
port=$(sed -n 's/.*:\([0-9]*\) to .*/\1/p' said)
for n in 1 2 3; do say $n; done
wait $!
judge() {
  rocinante check cell.toml "$1" | grep -E 'left-out|compatible' || true
  rocinante render cell.toml "$1" --at 0s --size 32x24 -o x.png 2>&1 | grep -o 'the recording.*' || true
  printf 'format = 1\ncell = "cell.toml"\nlog = "%s"\n[[run]]\nname = "r"\nalign = "origin"\n' "$1" >s.toml
  rocinante golden run s.toml 2>&1 | grep -o 'the recording.*' || true
}
echo "-- beside the others"
judge p-001.mcap
cp p-001.mcap first.mcap
touch -d "1 hour" first.mcap  # as if the copy had been made much later than the next piece was
echo "-- the first, by another name beside the others"
judge first.mcap
mkdir first last
cp p-001.mcap first
cp p-003.mcap last
echo "-- the first, alone"
judge first/p-001.mcap
echo "-- the last, alone"
judge last/p-003.mcap
