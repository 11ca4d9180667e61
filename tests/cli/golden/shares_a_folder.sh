# Two suites beside each other share a folder of goldens: neither calls the other's stale.
export ROCINANTE_USER=ada
cp "$SRC/examples/demo/session.mcap" .
suite() {
  printf 'format = 1\ncell = "%s"\nlog = "session.mcap"\n[defaults]\nsize = [64, 48]\n[[case]]\nname = "%s"\n%s\n' \
    "$SRC/examples/demo/demo.cell.toml" "$1" "$2" >"$1.toml"
}
suite first 'at = "1s"'
suite second 'every = "9s"'
rocinante golden approve first.toml -m first | tail -1
rocinante golden approve second.toml -m second | tail -1
for name in first second; do
  rocinante golden run $name.toml
  rocinante golden list $name.toml | tail -1
done
echo "-- the second is gone"
rm second.toml
rocinante golden run first.toml | sed -E 's/\.[0-9a-f]{8}\.png/.KEY.png/'
