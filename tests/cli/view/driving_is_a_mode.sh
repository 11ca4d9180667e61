# What a window sends to a machine while it drives: the joint that the hand moves and no other, by name, and nothing once
# Space, N, Esc or Backspace ended the mode, however long the window goes on, whatever the log has. A red frame shows the mode.
export ASAN_OPTIONS=detect_leaks=0 XDG_CACHE_HOME=$PWD/cache
cat >arm.urdf <<'URDF'
<robot name="arm"><link name="base"><visual><geometry><box size="0.4 0.4 0.2"/></geometry></visual></link>
<link name="one"><visual><geometry><box size="0.1 0.1 0.6"/></geometry></visual></link><link name="two"/><link name="three"/>
<joint name="a" type="continuous"><parent link="base"/><child link="one"/><axis xyz="0 0 1"/></joint>
<joint name="b" type="continuous"><parent link="one"/><child link="two"/><axis xyz="0 1 0"/></joint>
<joint name="c" type="continuous"><parent link="two"/><child link="three"/><axis xyz="0 1 0"/></joint></robot>
URDF
{ echo 't,arm.a,arm.b,arm.c'; for i in $(seq 0 2999); do echo "$((i / 10)).$((i % 10)),$((i % 7)),0.5,1"; done; } >motion.csv
rocinante record 127.0.0.1:0 -o driven.mcap >/dev/null 2>said &
recorder=$!
until grep -qs '^recording' said; do kill -0 $recorder; sleep 0.05; done
machine=127.0.0.1:$(sed 's/.*:\([0-9]*\) to .*/\1/' said)
port=$((20000 + ($$ + 7) % 20000))
rocinante source --csv motion.csv --to "127.0.0.1:$port" >/dev/null 2>&1 &
source=$!
cat >script.txt <<SCRIPT
panels off
await 1s
drive $machine,space
joint arm/a 10deg
frame 4
key space
frame 4
key space
frame 150
now
drive $machine,lets-go
joint arm/a 0.25
joint arm/b 0.5
frame 4
reset arm/a
frame 130
key N
frame 150
drive
frame 150
joint arm/c 0.25
key escape
frame 150
drive
joint arm/c 0.5
frame 4
press escape
frame 150
drive
joint arm/c 0.75
frame 4
key backspace
frame 150
drive
pause
joint arm/a 1
frame 150
quit
SCRIPT
with_display rocinante view arm.urdf --live "127.0.0.1:$port" --size 160x120 --samples 1 --script script.txt
kill $source
wait $source 2>/dev/null
kill -INT $recorder
wait $recorder
rocinante log cat driven.mcap | sed -n 's/^.*RK1 \([a-z-]*\)@[0-9a-f]* \([0-9]*\) [0-9.]*/\1 \2/p; /^ *joint/p'

cat >frame.txt <<SCRIPT
panels off
camera @3,-3,2/0,0,0
screenshot before.png
drive $machine,me
screenshot driving.png
joint arm/a 0
key escape
reset all
frame 2
screenshot after.png
quit
SCRIPT
with_display rocinante view arm.urdf --size 320x240 --profile reproducible --script frame.txt
rocinante golden compare before.png driving.png --quiet | sed 's/:.*//' || true
rocinante golden compare before.png after.png
