# README's own way: a recording of 20 s that carries its cell. Its page is as large as that of the same recording
# without a cell, when the cell is named: the cell is in it once. The viewer is a stand-in, as its size is that of both.
mkdir viewer && echo 'var rocinanteViewer;' >viewer/rocinante-viewer.js && echo wasm >viewer/rocinante-viewer.wasm
demo=$SRC/examples/demo
rocinante log attach "$demo/motion.mcap" --cell "$demo/demo.cell.toml" -o carries.mcap >/dev/null
rocinante page carries.mcap -o carries.html --viewer viewer >/dev/null
rocinante page "$demo/demo.cell.toml" "$demo/motion.mcap" -o named.html --viewer viewer >/dev/null
python3 - <<'PY'
import os
size = os.path.getsize
print("the log carries something:", size("carries.mcap") > 3 * size(os.environ["SRC"] + "/examples/demo/motion.mcap"))
print("no larger:", size("carries.html") <= 1.1 * size("named.html"))
PY
