# The telegrams of a drive become signals, which the cell's rules judge; a NaN is no value, and named.
cp "$SRC/examples/decoders/drive_telegram.decoders.toml" drive.decoders.toml
cat >arm.urdf <<'X'
<robot name="arm"> <link name="base"/> <link name="tool0"/>
  <joint name="turn" type="revolute"> <parent link="base"/> <child link="tool0"/>
  <axis xyz="0 0 1"/> <limit lower="-1" upper="1" effort="1" velocity="9"/> </joint> </robot>
X
cat >arm.cell.toml <<'X'
format = 1
decoders = "drive.decoders.toml"
[[device]]
name = "arm"
model = "arm.urdf"
[[signal]]
path = "arm"
name = "j*.current"
unit = "A"
range = [-4, 4]
[[signal]]
path = "arm"
name = "mode"
values = ["idle", "auto", "fault"]
X
rocinante record 127.0.0.1:0 -o raw.mcap --max-packets 3 >/dev/null 2>said &
recorder=$!
until grep -qs '^recording' said; do sleep 0.05; done
port=$(sed 's/.*:\([0-9]*\) to .*/\1/' said)
exec 3>/dev/udp/127.0.0.1/"$port"
#           status  currents 1.5, -0.01, 5 A     25 degC           force 12.5, NaN, 1 N
printf '\x00\x18\x00\x96\xff\xff\x01\xf4\x41\x00\x00\x00\x41\x48\x00\x00' >&3
printf '\x00\x10\x00\x96\xff\xff\x00\x00\x41\x00\x00\x00\x7f\xc0\x00\x00' >&3
printf '\x00\x50\x00\x96\xff\xff\x00\x00\x41\x00\x00\x00\x3f\x80\x00\x00' >&3
wait $recorder
rocinante log decode raw.mcap --decoders drive.decoders.toml -o decoded.mcap | sed 1d
rocinante log cat decoded.mcap --channel '/rocinante/decoded/*' | sed 's/.*RK1 [^|]*| //'
rocinante check arm.cell.toml raw.mcap 2>&1 | grep -v '1 time at\|over 0\|such as' || echo "exit $?"
