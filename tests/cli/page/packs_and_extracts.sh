# A page carries the log byte for byte, and is the same wherever the cell lies. The viewer is a
# stand-in: packing does not look into it.
mkdir viewer && echo 'var rocinanteViewer;' >viewer/rocinante-viewer.js && echo wasm >viewer/rocinante-viewer.wasm
cp -r "$SRC/examples/demo" demo
rocinante page demo/session.mcap demo/demo.cell.toml -o session.html --viewer viewer | sed 's/: .*, with/: N, with/'
(cd demo && rocinante page session.mcap demo.cell.toml -o ../again.html --viewer ../viewer >/dev/null)
cmp session.html again.html
if grep -aqF "$PWD" session.html; then echo "gives a folder away"; fi
rocinante page --extract session.html -o log.mcap
cmp log.mcap demo/session.mcap
# A log that carries its cell.
rocinante log attach demo/session.mcap --cell demo/demo.cell.toml -o carries.mcap >/dev/null
rocinante page carries.mcap -o carries.html --viewer viewer --size 30MB | sed 's/: .*, with a log.*/: N/'
# A part of it: what `log cut` makes, with the session's own times.
for page in part.html part2.html; do
  rocinante page demo/session.mcap demo/demo.cell.toml -o $page --viewer viewer --from 4s --until 6.5s | sed 's/: .*, with a log.*/: N/'
done
cmp part.html part2.html
ls | grep -F .cut. || true
rocinante page --extract part.html -o part.mcap >/dev/null
rocinante log cut demo/session.mcap --from 4s --until 6.5s -o cut.mcap >/dev/null
rocinante log diff part.mcap cut.mcap >/dev/null && echo "as cut"
for log in part.mcap demo/session.mcap; do rocinante model fk demo/demo.cell.toml --log $log --at 5.25s --json >$(basename $log).json; done
cmp part.mcap.json session.mcap.json
