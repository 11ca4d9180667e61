# While somebody writes a decoder: what it makes, the last values, what no line uses, and what the
# datagrams have besides; for XML and for protobuf.
grep -q '^  protobuf *on ' <(rocinante --version --parts) || { echo "skipped: built without protobuf"; exit 77; }
cat >traffic.py <<'PY'
import sys
sys.path.insert(0, sys.argv[1])
from udp_capture import egm, write_capture
telegram = '<Rob Type="KUKA"><AIPos A1="%d" A2="-90.0"/><Delay D="7"/></Rob>'
write_capture("all.pcap", [(0.0, (telegram % 10).encode(), 5000), (0.1, egm(1, [1, 2, 3]), 5001), (0.2, b"neither", 5002),
                           (0.3, (telegram % 20).encode(), 5000), (0.4, egm(2, [4, 5, 6]), 5001)], 49152)
PY
python3 traffic.py "$SRC/tests/support"
cat >both.decoders.toml <<'TOML'
[[decoder]]
name = "kuka"
kind = "xml"
begins_with = "<Rob"
[[decoder.field]]
name = "A1"
at = "AIPos@A1"
[[decoder.field]]
name = "A3"
at = "AIPos@A3"
[[decoder.joint]]
device = "kr10"
joint = "a1"
field = "A1"
degrees = true
[[decoder]]
name = "egm"
kind = "protobuf"
descriptor = "abb_egm.binpb"
message = "abb.egm.EgmRobot"
[[decoder.field]]
name = "J"
at = "feedBack.joints.joints"
count = 2
[[decoder.joint]]
device = "irb"
joint = "j1"
field = "J[0]"
degrees = true
TOML
cp "$SRC/examples/decoders/abb_egm.binpb" .
rocinante spy pcap://./all.pcap --decoders both.decoders.toml || echo "exit $?"
rocinante spy pcap://./all.pcap --decoders both.decoders.toml --json | sed -n '/"decoders": \[/,/^  \],/p'
sed -i 's/AIPos@A3/AIPos@/' both.decoders.toml
rocinante spy pcap://./all.pcap --decoders both.decoders.toml || echo "exit $?"
