# What an included cell says of rules is faulted where it stands, also out of a log, and counts below what the
# cell itself says.
cat >arm.urdf <<'XML'
<robot name="arm"> <link name="base"/> </robot>
XML
cat >site.cell.toml <<'TOML'
format = 1
[rules]
"packet.unknown-layer" = "off"
"packet.unknwon-link" = "note"
"joint.limit" = { ms = 3 }
TOML
cat >cell.toml <<'TOML'
format = 1
include = ["site.cell.toml"]
[[device]]
model = "arm.urdf"
[rules]
"joint.lmit" = "note"
TOML
rocinante check cell.toml || echo "exit $?"
