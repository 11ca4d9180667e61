# A finding of the watch writes the ring, with what came before it. A capture file is judged in its own time.
cat >arm.urdf <<'URDF'
<robot name="arm">
  <link name="base"/>
  <link name="hand"/>
  <joint name="turn" type="revolute"> <parent link="base"/> <child link="hand"/>
    <limit lower="-2" upper="2" effort="1" velocity="9"/> </joint>
</robot>
URDF
python3 "$SRC/tests/support/joint_capture.py" session.pcap
rocinante record pcap://./session.pcap -o 'error-%n.mcap' --ring 1s --ring-after 500ms --watch arm.urdf --json 2>&1 |
  grep -v sha256 | grep -E 'arm/turn|"(why|triggers|packets|log)"|written' | sed 's/, [0-9.]* [kM]*B//'
rocinante log info error-001.mcap --json | grep -E '"(messages|start|end)":' | sed -n 1,3p
echo "== warnings too: the silence"
rocinante record pcap://./session.pcap -o 'warning-%n.mcap' --ring 1s --watch arm.urdf --watch-severity warning --quiet
ls
for log in warning-*.mcap; do rocinante check arm.urdf $log --quiet || echo "exit $?"; done
echo "== a cell that is none"
rocinante record pcap://./session.pcap -o 'no-%n.mcap' --ring 1s --watch missing.urdf --quiet || echo "exit $?"
