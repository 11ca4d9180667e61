# The cell that a log carries is compared with the one it is judged with: what a replay would show
# wrong is said. With its own cell nothing has drifted.
cat >cell.toml <<'TOML'
format = 1
[[device]]
name = "arm"
model = "arm.urdf"
TOML
cat >arm.urdf <<'URDF'
<robot name="arm">
  <link name="base"/> <link name="upper"/> <link name="hand"/>
  <joint name="shoulder" type="continuous"> <parent link="base"/> <child link="upper"/> </joint>
  <joint name="elbow" type="continuous"> <parent link="upper"/> <child link="hand"/> </joint>
</robot>
URDF
rocinante record 127.0.0.1:0 -o log.mcap --cell cell.toml --max-packets 1 >/dev/null 2>said &
until grep -qs '^recording' said; do kill -0 $!; sleep 0.05; done
printf 'RK1 me@a 0 -\njoints arm 0.5 1\n' >packet
cat packet >"/dev/udp/127.0.0.1/$(sed 's/.*:\([0-9]*\) to .*/\1/' said)"  # in one write: one datagram
wait $!
rocinante check log.mcap | tail -n 1
rocinante check cell.toml log.mcap | tail -n 1
# The elbow comes first.
{ sed -n 1,2p arm.urdf; sed -n 4p arm.urdf; sed -n 3p arm.urdf; sed -n 5p arm.urdf; } >swapped.urdf
mv swapped.urdf arm.urdf
rocinante check cell.toml log.mcap || echo "exit $?"
