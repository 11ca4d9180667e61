# What cannot become a page is said in one sentence, and nothing is written.
mkdir viewer && echo 'var rocinanteViewer;' >viewer/rocinante-viewer.js && echo wasm >viewer/rocinante-viewer.wasm
demo=$SRC/examples/demo
page() { rocinante page "$@" || echo "exit $?"; }
page -o a.html
page "$demo/session.mcap" "$demo/demo.cell.toml" -o a.html --viewer nowhere
page "$demo/session.mcap" "$demo/demo.cell.toml" -o a.html --viewer viewer --size 300kB 2>&1 | sed 's/have [0-9.]* [kM]B/have N/'
page "$demo/session.mcap" "$demo/demo.cell.toml" -o a.html --viewer viewer --size many
page "$demo/session.mcap" "$demo/demo.cell.toml" -o a.html --viewer viewer --from noon
page "$demo/session.mcap" "$demo/demo.cell.toml" -o a.html --viewer viewer --from 1h 2>&1 | sed "s|$SRC|SRC|g"
page "$demo/session.mcap" -o a.html --viewer viewer 2>&1 | sed "s|$SRC|SRC|g"
page "$demo/demo.cell.toml" -o a.html --viewer viewer 2>&1 | sed "s|$SRC|SRC|g"
page nowhere.mcap "$demo/demo.cell.toml" -o a.html --viewer viewer
page --extract "$demo/arm.urdf" -o a.mcap 2>&1 | sed "s|$SRC|SRC|g"
page --extract a.html "$demo/session.mcap" -o a.mcap
page --extract a.html -o a.mcap --from 1s
echo kept >a.html
page "$demo/session.mcap" "$demo/demo.cell.toml" -o a.html --viewer viewer
cat a.html
