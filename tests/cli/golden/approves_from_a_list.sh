# A list approves what somebody saw, and nothing else.
export ROCINANTE_USER=ada
cat >box.urdf <<'URDF'
<robot name="box"><link name="body"><visual><geometry><box size="1 1 1"/></geometry></visual></link></robot>
URDF
cat >suite.toml <<'TOML'
format = 1
cell = "box.urdf"
[defaults]
size = [64, 48]
samples = 1
[[case]]
name = "a"
[[case]]
name = "b"
hide = ["layer/grid"]
TOML
rocinante golden run suite.toml --jobs 1 --json >seen.json || echo "exit $?"
python3 -c '
import json
for frame in json.load(open("seen.json"))["frames"]:
    print(frame["name"], frame["pixels"], sep="\t")' >list.txt
head -1 list.txt >one.txt
rocinante golden approve suite.toml --from one.txt -m 'seen'
rocinante golden list suite.toml | awk '{print $1, $4, $6}' || echo "exit $?"
# What is drawn now is not what was seen.
sed 's/size="1 1 1"/size="1 1 2"/' -i box.urdf
rocinante golden approve suite.toml --from list.txt -m 'seen' || echo "exit $?"
echo 'gone 0123456789abcdef0123456789abcdef' >gone.txt
rocinante golden approve suite.toml --from gone.txt -m 'seen' || echo "exit $?"
echo 'a 0123' >wrong.txt
rocinante golden approve suite.toml --from wrong.txt -m 'seen' || echo "exit $?"
rocinante golden approve suite.toml -i -m 'seen' || echo "exit $?"
