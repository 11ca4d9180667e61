# A page begins with a layout of the window, names what it has not of it, and takes no other file for one.
mkdir viewer && echo 'var rocinanteViewer;' >viewer/rocinante-viewer.js && echo wasm >viewer/rocinante-viewer.wasm
demo=$SRC/examples/demo
page() { rocinante page "$demo/session.mcap" "$demo/demo.cell.toml" --viewer viewer "$@"; }
cat >forces.layout.toml <<'TOML'
format = 1
theme = "light"
camera = "overview"
plots = ["arm.joint2", "d/dt arm.joint2", "arm.joint2 over arm.joint1", "leg.joint2", "rate"]
plots_height = 200.0
insets = ["map:top-left", "attic"]

[[panel]]
name = "left"
collapsed = true
TOML
page -o session.html --layout forces.layout.toml | sed 's/: .*, with a log.*/: N/'
grep -o 'id="rocinante-layout">[^<]*' session.html | cut -d'>' -f2 | base64 -d | gunzip
echo
grep -c 'color-scheme: light;' session.html
page -o again.html --layout forces.layout.toml >/dev/null
cmp session.html again.html
page -o plain.html | sed 's/: .*, with a log.*/: N/'
grep -c 'rocinante-layout"' plain.html || true
printf '%s\n' 'format = 1' 'theme = "blue"' >bad.layout.toml
page -o bad.html --layout bad.layout.toml || echo "exit $?"
page -o bad.html --layout none.layout.toml || echo "exit $?"
rocinante page --extract session.html -o log.mcap --layout forces.layout.toml || echo "exit $?"
ls bad.html log.mcap 2>/dev/null || true
