# A log whose attached cell is damaged is judged all the same, and says that drift is unknown.
cat >cell.toml <<'TOML'
format = 1
[[device]]
name = "arm"
model = "arm.urdf"
TOML
echo '<robot name="arm"> <link name="base"/> </robot>' >arm.urdf
rocinante record 127.0.0.1:0 -o log.mcap --cell cell.toml --max-packets 1 >/dev/null 2>said &
until grep -qs '^recording' said; do kill -0 $!; sleep 0.05; done
printf 'RK1 me@a 0 -\npose arm 0 0 1 0 0 0 1\n' >packet
cat packet >"/dev/udp/127.0.0.1/$(sed -n 's/^recording.*:\([0-9]*\) to .*/\1/p' said)"  # in one write
wait $!
python3 - <<'PY'
log = open("log.mcap", "rb").read()
open("log.mcap", "wb").write(log.replace(b'<link name="base"/>', b'<link name="bass"/>'))
PY
rocinante check cell.toml log.mcap
rocinante check log.mcap || echo "exit $?"
