# check CELL LOG decodes what the log has no packets of, by the cell's decoders or by those that are
# given; a recording of another program and a log that was decoded before are judged alike.
cat >traffic.py <<'PY'
import sys
sys.path.insert(0, sys.argv[1])
from udp_capture import write_capture
telegram = ('<Rob Type="KUKA"><RIst X="445.0" Y="0.0" Z="790.0" A="90.0" B="0.0" C="0.0"/><AIPos A1="%d" A2="-90.0" '
            'A3="90.0" A4="0.0" A5="45.0" A6="180.0"/><Delay D="0"/></Rob>')
datagrams = [(0.1 * i, (telegram % (i * i)).encode(), 5000) for i in range(6)]
write_capture("all.pcap", sorted(datagrams + [(0.35, b"<Rob>cut", 5000)]), 49152)
PY
python3 traffic.py "$SRC/tests/support"
cp "$SRC/examples/decoders/kuka_rsi.decoders.toml" kuka.decoders.toml
joint() { printf '<joint name="joint_a%d" type="revolute"><parent link="l%d"/><child link="l%d"/><axis xyz="0 0 1"/><limit lower="%s" upper="%s" velocity="9" effort="9"/></joint>' $1 $1 $(($1 + 1)) $2 $3; }
{ printf '<robot name="kr10">'; for n in 1 2 3 4 5 6 7; do printf '<link name="l%d"/>' $n; done
  joint 1 -0.3 0.3; for n in 2 3 4 5 6; do joint $n -4 4; done; printf '</robot>'; } >kr10.urdf
printf '<robot name="tool"><link name="base"/></robot>' >tool.urdf
cell() {
  printf 'format = 1\n%s\n[[device]]\nname = "kr10"\nmodel = "kr10.urdf"\n[[device]]\nname = "tool"\nmodel = "tool.urdf"\n' "$1" >"$2"
}
cell 'decoders = "kuka.decoders.toml"' with.cell.toml
cell '' without.cell.toml
rocinante record pcap://./all.pcap -o raw.mcap --quiet
rocinante log decode raw.mcap --decoders kuka.decoders.toml -o decoded.mcap >/dev/null
findings() { rocinante check "$@" --json | grep -E '"(rule|packets|datagrams|verdict|device|joint|count)"' || true; }
echo "# a log"
findings with.cell.toml raw.mcap | tee first
for way in "without.cell.toml raw.mcap --decoders kuka.decoders.toml" "with.cell.toml all.pcap" "with.cell.toml decoded.mcap" \
  "without.cell.toml --live pcap://./all.pcap --decoders kuka.decoders.toml"; do
  findings $way 2>/dev/null | cmp - first && echo "the same: $way"
done
echo "# without decoders"
findings without.cell.toml raw.mcap
echo "# refusals"
rocinante check with.cell.toml --decoders kuka.decoders.toml || echo "exit $?"
sed -i 's/at = "AIPos@A1"//' kuka.decoders.toml
rocinante check with.cell.toml raw.mcap || echo "exit $?"
