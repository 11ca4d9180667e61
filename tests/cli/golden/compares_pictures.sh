# Any two pictures: every figure as JSON, the verdict alone when quiet; exit 0, 1 and 2.
cat >box.urdf <<'URDF'
<robot name="box"><link name="body"><visual><geometry><box size="1 1 1"/></geometry></visual></link></robot>
URDF
rocinante render box.urdf --size 320x240 -o a.png 2>/dev/null
rocinante render box.urdf --size 320x240 --hide layer/gnomon -o b.png 2>/dev/null
rocinante render box.urdf --size 160x240 -o c.png 2>/dev/null
rocinante golden compare a.png a.png
rocinante golden compare a.png c.png || echo "exit $?"
rocinante golden compare a.png b.png --quiet || echo "exit $?"
rocinante golden compare a.png b.png --json >answer.json || echo "exit $?"
python3 -c '
import json
answer = json.load(open("answer.json"))
print(list(answer), answer["verdict"], answer["pixels_over"].keys() == {"1", "2", "8", "32"})'
rocinante golden compare a.png missing.png || echo "exit $?"
rocinante golden compare a.png box.urdf 2>&1 | cut -c1-18 || echo "exit $?"
rocinante golden compare a.png b.png --tier lax || echo "exit $?"
