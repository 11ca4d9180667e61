# The block of docs/programs/golden.md that begins a suite, as it stands there, but small.
cp "$SRC"/examples/demo/*.* . && cp -r "$SRC/examples/demo/arm" "$SRC/examples/demo/textures" .
mv demo.cell.toml cell.toml && rm demo.suite.toml
awk '/first_suite.sh runs this block/ {found = 1} found && /^```/ {if (inside) exit; inside = 1; next} inside' \
  "$SRC/docs/programs/golden.md" >block.sh
export ROCINANTE_USER=me
while read -r line; do
  case $line in *" add "*) line="$line --size 48x36 --samples 1" ;; esac
  bash -eu -o pipefail -c "$line" || echo "exit $?"
done <block.sh
ls report/index.html
