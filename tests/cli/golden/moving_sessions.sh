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
# recorded NAME STEP TURN: a log of sixteen packets, one each STEP seconds, that turn the arm by TURN each.
# Its times are written, not waited for: a machine that stalls stretches what it records.
recorded() {
  python3 -c 'import sys; print("t,turn"); [print(f"{float(sys.argv[1]) * i:.3f},{float(sys.argv[2]) * i:.1f}") for i in range(16)]' "$2" "$3" >"$1.csv"
  rocinante log import "$1.csv" --cell cell.toml --device arm -o "$1.mcap" >/dev/null
}
recorded a 0.020 0.1
recorded b 0.023 0.1
recorded c 0.020 -0.1
judged() { rocinante golden session "$@" --size 96x72 | sed -nE 's/^pictures +(0|[1-9])[0-9]* .*/\1/p' | sed 's/^0/pictures: the same/; s/^[1-9]/pictures differ/' || true; }
judged a.mcap b.mcap --event-ms 60
judged b.mcap a.mcap --event-ms 60
judged a.mcap c.mcap --event-ms 60
judged a.mcap b.mcap --event-ms 20  # the end is 45 ms later
judged a.mcap b.mcap arm.urdf --event-ms 60
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
