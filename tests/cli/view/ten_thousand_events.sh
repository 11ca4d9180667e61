# A log with ten thousand events: all are listed, a part of a name finds one among them, a click goes there, and the
# next ones follow it.
export ASAN_OPTIONS=detect_leaks=0
cat >arm.urdf <<'URDF'
<robot name="arm">
  <link name="base"><visual><geometry><box size="1 1 0.2"/></geometry></visual></link>
  <link name="boom"><visual><origin xyz="0.5 0 0"/><geometry><box size="1 0.2 0.2"/></geometry></visual></link>
  <joint name="turn" type="revolute"><parent link="base"/><child link="boom"/><axis xyz="0 0 1"/>
    <limit lower="-2" upper="2" effort="1" velocity="1"/></joint>
</robot>
URDF
cat >make.py <<'PYTHON'
import os, sys
sys.path.insert(0, os.environ["SRC"] + "/tests/support")
from mcap_file import McapFile
start = 1770000000 * 10**9
arm = (1, "/udp/5000/arm", "rk1", {"source": "arm", "remote": "127.0.0.1:5000"})
log = McapFile("rocinante", "rocinante").session(start)
for first in range(0, 10_000, 500):
    log.chunk([(arm, start + i * 10**7, f'RK1 arm {i} -\njoints arm {i / 5000}\nevent "step {i}"\n'.encode())
               for i in range(first, first + 500)])
log.metadata("rocinante.end", {"reason": "closed", "session_id": "s", "origin_ns": str(start)})
log.save("log.mcap")
PYTHON
python3 make.py
cat >script.txt <<'SCRIPT'
frame 2
mouse 135 20   # the tab Events, which must know that the mouse is over it (ImGui 1.92)
frame 2
button left down
frame 1
button left up
frame 2
mouse 140 48   # find an event
frame 2
button left down
frame 1
button left up
frame 1
type 9876
frame 2
mouse 110 72   # the only one that is listed
frame 2
button left down
frame 1
button left up
frame 2
panels off
frame 1
evidence found.png
event next
frame 1
evidence next.png
end
event previous
event next
frame 1
evidence last.png
SCRIPT
with_display rocinante view arm.urdf log.mcap --camera @3,-3,3/0,0,0 --size 640x480 --samples 1 --profile reproducible \
  --script script.txt
for moment in found:98.76 next:98.77 last:99.99; do
  rocinante render arm.urdf log.mcap --camera @3,-3,3/0,0,0 --at "${moment#*:}s" --size 640x480 --samples 1 --force -o there.png
  rocinante golden compare "${moment%:*}.png" there.png --tier exact | sed 's/^same:.*/same/'
done
