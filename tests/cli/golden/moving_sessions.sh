# Two recordings of one motion never hold the same moment; their pictures are those of the same state all the same.
cat >arm.urdf <<'URDF'
<robot name="arm">
  <link name="base"/>
  <link name="bar"><visual><origin xyz="0.5 0 0"/><geometry><box size="1 0.2 0.2"/></geometry></visual></link>
  <joint name="turn" type="continuous"><parent link="base"/><child link="bar"/><axis xyz="0 0 1"/></joint>
</robot>
URDF
cat >cell.toml <<'TOML'
format = 1
[[device]]
model = "arm.urdf"
[[camera]]
name = "above"
eye = [0, -2, 3]
target = [0, 0, 0]
TOML
python3 -c 'print("t,turn"); [print(f"{0.02 * i:.2f},{0.1 * i:.1f}") for i in range(16)]' >there.csv
python3 -c 'print("t,turn"); [print(f"{0.02 * i:.2f},{-0.1 * i:.1f}") for i in range(16)]' >back.csv
recorded() {
  rm -f said  # of the one before
  rocinante record 127.0.0.1:0 -o "$1.mcap" --cell cell.toml --max-packets 17 --duration 90s >/dev/null 2>said &
  until grep -qs '^recording' said; do kill -0 $!; sleep 0.05; done
  port=$(sed -n 's/^recording.*:\([0-9]*\) to .*/\1/p' said)
  rocinante source --csv "$2.csv" --device arm --restate 0 --quiet --to "127.0.0.1:$port" >/dev/null 2>&1
  wait $!
}
recorded a there
recorded b there
recorded c back
judged() { rocinante golden session "$@" --size 96x72 --event-ms 1000 | sed -nE 's/^pictures +(0|[1-9])[0-9]* .*/\1/p' | sed 's/^0/pictures: the same/; s/^[1-9]/pictures differ/' || true; }
judged a.mcap b.mcap
judged b.mcap a.mcap
judged a.mcap c.mcap
judged a.mcap b.mcap arm.urdf
# A session's extent moves what is fitted to it, main view and inset: both are drawn as the first has it.
cat >fitted.toml <<'TOML'
format = 1
[[device]]
model = "arm.urdf"
[[inset]]
camera = "map"
TOML
rocinante log cut c.mcap --until 0.15s -o half.mcap >/dev/null 2>&1
rocinante golden session c.mcap half.mcap fitted.toml --size 96x72 --tier exact | sed -n '/^pictures/,/note/p' || true
rocinante golden bisect c.mcap fitted.toml --size 96x72 --other-log half.mcap | sed 's/of [0-9]* moments/of N moments/'
