# A page that would be too large is made smaller where that is asked for: coarser pictures and meshes, no further than
# needed, the log whole. It says what it left out, and says the same every time.
mkdir viewer && echo 'var rocinanteViewer;' >viewer/rocinante-viewer.js && echo wasm >viewer/rocinante-viewer.wasm
demo=$SRC/examples/demo
page() { rocinante page "$demo/session.mcap" "$demo/demo.cell.toml" --viewer viewer --thin "$@"; }
sizes() { sed 's/[0-9.]* [kM]B/N/g'; }
page -o whole.html | sizes
page -o half.html --size 700kB | sizes
page -o again.html --size 700kB >/dev/null
cmp half.html again.html
page -o small.html --size 600kB | sizes
for html in half small; do
  rocinante page --extract $html.html -o $html.mcap >/dev/null
  cmp $html.mcap "$demo/session.mcap"
  grep -o 'data-left-out="Made smaller' $html.html
done
[ "$(stat -c %s half.html)" -le 700000 ] && [ "$(stat -c %s small.html)" -le 600000 ] && echo "as small as was asked for"
page -o a.html --size 200kB 2>&1 | sizes || true
ls -- *.html
