# What a watch tells, of a capture file: its times are the file's. At 2 s a joint leaves its limits for
# 1 s, from 5 s to 20 s the source is silent.
cat >cell.toml <<'TOML'
format = 1
[[device]]
name = "arm"
model = "arm.urdf"
TOML
cat >arm.urdf <<'URDF'
<robot name="arm">
  <link name="base"/>
  <link name="hand"/>
  <joint name="turn" type="revolute"> <parent link="base"/> <child link="hand"/>
    <limit lower="-2" upper="2" effort="1" velocity="9"/> </joint>
</robot>
URDF
python3 "$SRC/tests/support/joint_capture.py" session.pcap
watch() { rocinante check cell.toml --live pcap://./session.pcap --watch "$@" || echo "exit $?"; }
watch
echo "== what is severe, as JSON"
watch --watch-severity error --json
echo "== until the first"
watch --until-finding --quiet
echo "== with a rule of its own, and a baseline"
cat >known.json <<'JSON'
{"format": 1, "accepted": [
  {"rule": "joint.limit", "subject": "arm", "text": "arm/turn is outside its limits [#, #]; the worst is #"}]}
JSON
watch --rule source.silence=off --rule source.unrestated=off --baseline known.json
echo "== a command"
cat >alarm <<'SH'
#!/bin/sh
sed 's/.*"event":"\([a-z]*\)".*"rule":"\([a-z.]*\)".*/alarm: \2 \1/'
SH
chmod +x alarm
watch --watch-severity error --quiet --on-finding ./alarm 2>said || true
sort said
echo "== refused"
try() { rocinante check "$@" || echo "exit $?"; }
try cell.toml --watch
try cell.toml --live :0 --until-finding
try cell.toml --live :0 --watch --format sarif
try cell.toml --live :0 --watch -o junit=x.xml
try cell.toml --live :0 --watch --hold 0s
try cell.toml --live :0 --watch --on-finding ' '
try cell.toml --live :0 --watch --on-finding no-such-program-at-all
try cell.toml --live :0 --watch --baseline known.json --update-baseline
