# What an ABB controller sends by protobuf becomes packets; the log carries the descriptor too, and
# what it carries decodes anew. A descriptor that is not the declared one is a fault with its place.
grep -q '^  protobuf *on ' <(rocinante --version --parts) || { echo "skipped: built without protobuf"; exit 77; }
cat >traffic.py <<'PY'
import sys
sys.path.insert(0, sys.argv[1])
from udp_capture import egm, message, write_capture
telegrams = [(0.004 * i, egm(i, [10.0 * i, -90, 90, 0, 45, 180], 1 + (i > 3)), 5000) for i in range(6)]
telegrams += [(0.0201, b"\x0a\x05cut", 5000), (0.0202, message(77, b"other"), 5000)]
write_capture("egm.pcap", sorted(telegrams), 6510)
PY
python3 traffic.py "$SRC/tests/support"
cp "$SRC"/examples/decoders/abb_egm.{decoders.toml,binpb} .
rocinante record pcap://./egm.pcap -o raw.mcap --quiet
rocinante log decode raw.mcap --decoders abb_egm.decoders.toml -o decoded.mcap | sed 1d
rocinante log doctor decoded.mcap >/dev/null && echo sound
rocinante log cat decoded.mcap --channel '/rocinante/decoded/*' | tail -n 4
rocinante log extract decoded.mcap --list | tr -s ' '
echo "# live"
rocinante record pcap://./egm.pcap --decoders abb_egm.decoders.toml -o live.mcap --quiet
for log in live decoded; do rocinante log info $log.mcap --json | grep -E '"(content|decoded)_sha256"'; done | sort | uniq -c | sed 's/: .*//'
echo "# by what the log carries"
rocinante log extract decoded.mcap --all -o carried >/dev/null
rocinante log decode raw.mcap --decoders carried/decoders/*.toml -o again.mcap >/dev/null
for log in decoded again; do rocinante log info $log.mcap --json | grep decoded_sha256; done | uniq | wc -l
cmp <(rocinante log extract decoded.mcap --list) <(rocinante log extract again.mcap --list) && echo "the same attachments"
{ cat abb_egm.decoders.toml; sha256sum <abb_egm.binpb | cut -c 1-64 | tr -d '\n'; } | sha256sum | cut -c 1-64 >hash
[ -e "carried/decoders/$(cat hash).toml" ] && echo "the hash is that of the page"
echo "# refusals"
sed 's/EgmRobot/EgmSensor/' abb_egm.decoders.toml >other.decoders.toml
rocinante log decode raw.mcap --decoders other.decoders.toml -o no.mcap || echo "exit $?"
head -c 300 "$SRC/examples/decoders/abb_egm.binpb" >abb_egm.binpb
rocinante log decode raw.mcap --decoders abb_egm.decoders.toml -o no.mcap || echo "exit $?"
rm abb_egm.binpb
rocinante log decode raw.mcap --decoders abb_egm.decoders.toml -o no.mcap || echo "exit $?"
ROCINANTE_MODULES=$PWD rocinante log decode raw.mcap --decoders carried/decoders/*.toml -o no.mcap 2>&1 |
  sed "s|$PWD|HERE|g; s/[0-9a-f]\{64\}/HASH/" || echo "exit $?"
