# What a window publishes is an ordinary source: a recorder hears it, and another window watches it.
export ASAN_OPTIONS=detect_leaks=0
cat >box.urdf <<'URDF'
<robot name="box"><link name="body"><visual><geometry><box size="1 1 1"/></geometry></visual></link></robot>
URDF
cat >ann.txt <<'SCRIPT'
panels off
camera @3,-4,2/0,0,0
frame 2
point-at 160 120
draw on
click 150 130
click 170 130
draw off
label worn edge
click 160 110
say look here
frame 2
point-at 2 2
frame 10
quit
SCRIPT
rocinante record 127.0.0.1:0 -o s.mcap >/dev/null 2>said &
recorder=$!
until grep -qs '^recording' said; do kill -0 $recorder; sleep 0.05; done
to="127.0.0.1:$(sed 's/.*:\([0-9]*\) to .*/\1/' said)"
with_display rocinante view box.urdf --publish "$to" --as ann --size 320x240 \
  --profile reproducible --script ann.txt
kill -INT $recorder
wait $recorder
echo "record: exit $?"
# Where the surfaces are depends on the last bits of a renderer's depth.
rocinante log cat s.mcap | tr '|' '\n' | sed -n 's/^ \([a-z][a-z]* [^ ]*\).*/\1/p' | sort -u

# It is seen as long as it was there: as it closed, it took back what it had said.
for at in start end; do
  printf "$at\nwatch ann\nquit\n" >look.txt
  with_display rocinante view box.urdf s.mcap --size 320x240 --script look.txt 2>&1 && echo "$at: seen" || echo "$at: exit $?"
done

# Another window, live: it watches ann, and stays where ann looked.
cat >bob.txt <<'SCRIPT'
panels off
await 0.5s
frame 2
watch ann
frame 2
evidence bob.png
watch off
frame 2
evidence stays.png
watch eve
SCRIPT
printf 'panels off\ncamera @3,-4,2/0,0,0\nwait 100000\n' >ann.txt
seen() {
  rocinante view box.urdf --publish 127.0.0.1:29992 --as ann --size 320x240 --script ann.txt 2>/dev/null &
  rocinante view box.urdf --live 127.0.0.1:29992 --publish 127.0.0.1:29991 --as bob --size 320x240 \
    --profile reproducible --script bob.txt 2>&1 || echo "bob: exit $?"
  kill $!
  wait $! 2>/dev/null || true
}
export -f seen
with_display bash -c seen
rocinante render box.urdf --camera @3,-4,2/0,0,0 --size 320x240 -o alone.png
rocinante golden compare bob.png alone.png
rocinante golden compare stays.png alone.png
rocinante view box.urdf --publish 127.0.0.1:29991 2>&1 || echo "exit $?"
rocinante view box.urdf --as ann 2>&1 || echo "exit $?"
