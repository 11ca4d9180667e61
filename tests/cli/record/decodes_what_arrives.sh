# With --decoders a recording has the packets of a KUKA behind its datagrams, just as `log decode`
# makes them of a recording without, also by the decoders that the cell names. --start-on waits for
# what was decoded.
cat >traffic.py <<'END'
import struct

TELEGRAM = ('<Rob Type="KUKA"><RIst X="445.0" Y="0.0" Z="790.0" A="90.0" B="0.0" C="0.0"/><AIPos A1="%s" A2="-90.0" '
            'A3="90.0" A4="0.0" A5="45.0" A6="180.0"/><Delay D="%s"/></Rob>')
datagrams = [(0.1 * i, TELEGRAM % (10 * i, i // 3)) for i in range(6)]
datagrams += [(0.25, 'RK1 lamp@a 1 -\njoints lamp 1\n'), (0.35, '<Rob>cut'), (0.45, "somebody else's")]

with open('all.pcap', 'wb') as file:
    file.write(struct.pack('<IHHiIII', 0xa1b2c3d4, 2, 4, 0, 0, 65535, 101))
    for after, text in sorted(datagrams):
        udp = struct.pack('>HHHH', 5000, 49152, 8 + len(text), 0) + text.encode()
        ip = struct.pack('>BBHHHBBH4s4s', 0x45, 0, 20 + len(udp), 1, 0, 64, 17, 0, b'\x7f\0\0\1', b'\x7f\0\0\1')
        total = sum(struct.unpack('>10H', ip))
        total = (total & 0xffff) + (total >> 16)
        ip = ip[:10] + struct.pack('>H', 0xffff - total) + ip[12:]
        frame = ip + udp
        file.write(struct.pack('<IIII', 1700000000 + int(after), round(after % 1 * 1e6), len(frame), len(frame)) + frame)
END
python3 traffic.py
cp "$SRC/examples/decoders/kuka_rsi.decoders.toml" kuka.decoders.toml
joint() { printf '<joint name="joint_a%d" type="continuous"><parent link="l%d"/><child link="l%d"/></joint>' $1 $1 $(($1 + 1)); }
{ printf '<robot name="kr10">'; for n in 1 2 3 4 5 6 7; do printf '<link name="l%d"/>' $n; done
  for n in 1 2 3 4 5 6; do joint $n; done; printf '</robot>'; } >kr10.urdf
printf '<robot name="tool"><link name="base"/></robot>' >tool.urdf
cat >kuka.cell.toml <<'END'
format = 1
decoders = "kuka.decoders.toml"
[[device]]
name = "kr10"
model = "kr10.urdf"
[[device]]
name = "tool"
model = "tool.urdf"
END

echo "# record"
rocinante record pcap://./all.pcap --decoders kuka.decoders.toml -o live.mcap 2>/dev/null | sed 's/([0-9.]* [kM]*B)/(SIZE)/'
rocinante log info live.mcap | grep -E '^  (messages|attached|events)'
rocinante log doctor live.mcap >/dev/null && echo sound
rocinante record pcap://./all.pcap -o raw.mcap --quiet
rocinante log decode raw.mcap --decoders kuka.decoders.toml -o decoded.mcap >/dev/null
for log in live decoded; do
  rocinante log info $log.mcap --json | grep -E '"(content|decoded)_sha256"'
  rocinante log cat $log.mcap --channel '*' --format json >$log.json
done | sort | uniq -c | sed 's/: .*//'
cmp live.json decoded.json && echo "the same"
rocinante record pcap://./all.pcap --cell kuka.cell.toml -o cell.mcap --json 2>/dev/null | sed -n '/"decoded"/,$p'
rocinante log info cell.mcap --json | grep -c "$(rocinante log info live.mcap --json | grep decoded_sha256)"
rocinante record pcap://./all.pcap --cell cell.mcap -o from_log.mcap 2>/dev/null | grep decoded
rocinante record pcap://./all.pcap --decoders kuka.decoders.toml --start-on 'event=1 answers*' --stop-on device=lamp \
  --split-time 200ms -o 'piece-%n.mcap' 2>/dev/null | sed -n 1p | sed 's/([0-9.]* [kM]*B)/(SIZE)/'
echo "# refusals"
sed -i 's/at = "AIPos@A1"//' kuka.decoders.toml
rocinante record pcap://./all.pcap --decoders kuka.decoders.toml -o no.mcap || echo "exit $?"
rocinante record pcap://./all.pcap --cell kuka.cell.toml -o no.mcap 2>&1 | grep -v '^listening' || echo "exit $?"
ls no.mcap 2>/dev/null || echo "nothing recorded"
