# A window whose machine holds the frame rate shows everything soon after it opens, although a live stream leaves it no
# moment without a frame to get ready in.
export ASAN_OPTIONS=detect_leaks=0
cat >arm.urdf <<'URDF'
<robot name="arm"><link name="base"/><link name="hand"><visual><geometry><box size="1 2 1"/></geometry></visual></link>
<joint name="turn" type="continuous"><parent link="base"/><child link="hand"/></joint></robot>
URDF
awk 'BEGIN { print "t,turn"; for (i = 0; i < 1000; ++i) printf "%.3f,%.6f\n", i / 1000, i * 6.283185307 / 1000 }' >turn.csv
cat >person.sh <<'PERSON'
port=$((20000 + $$ % 9000))
rocinante source --csv turn.csv --device arm --loop 0 --speed 5 --to 127.0.0.1:$port --quiet 2>source.txt &
source=$!
rocinante view arm.urdf --live 127.0.0.1:$port --keep 0 --size 640x480 --target-fps 1 --frame-times frames.csv 2>view.txt &
viewer=$!
for turn in $(seq 300); do
  kill -0 $viewer || { cat view.txt; exit 1; }
  kill -0 $source || { cat source.txt; exit 1; }
  # Soon: in ten seconds or 60 pictures, of which none takes so long that it is more.
  awk -F, 'NR > 1 && $4 == 1 && $5 == 1 && !whole { ++drawn; if (!began) began = $1; late = drawn > 60 && $1 - began > 1e10
      if ($7 == 1) whole = NR; if (whole || late) { print late ? "late: " drawn " pictures" : "everything is shown"; exit }
    }' frames.csv >shown.txt 2>/dev/null
  [ -s shown.txt ] && cat shown.txt && break
  sleep 0.2
done
kill $viewer $source
wait $viewer
echo "view: exit $?"
PERSON
with_display bash person.sh
