# Known findings are accepted; new ones are not, and mended ones are named.
cat >cell.toml <<'TOML'
format = 1
[[device]]
name = "arm"
model = "arm.urdf"
colour = "#ff0000"
TOML
echo '<robot name="arm"><link name="base"/></robot>' >arm.urdf
rocinante check cell.toml --baseline known.json || echo "exit $?"
rocinante check cell.toml --baseline known.json --update-baseline
cat known.json
# Two lines lower, and still the same.
sed -i '1a # a comment\n# and another' cell.toml
rocinante check cell.toml --baseline known.json
echo 'colours = 3' >>cell.toml
rocinante check cell.toml --baseline known.json || echo "exit $?"
sed -i '/colour/d' cell.toml
rocinante check cell.toml --baseline known.json
rocinante check cell.toml --baseline known.json --fail-on note --quiet || echo "exit $?"
echo '{"format": 1, "accepted": [' >torn.json
rocinante check cell.toml --baseline torn.json || echo "exit $?"
echo '{"format": 1, "accepted": [{"rule": 7}]}' >wrong.json
rocinante check cell.toml --baseline wrong.json || echo "exit $?"
