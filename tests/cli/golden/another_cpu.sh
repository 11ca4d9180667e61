# What another class of processor draws is always the same picture to the tier that is made for it, and never the same
# bits until Mesa 25.0; those of Mesa 26 are equal too (docs/rendering.md). Threads change nothing at all.
if [ "$(uname -m)" != x86_64 ]; then echo "skipped: only on x86-64 is there a class of processor to choose"; exit 77; fi
draw() { rocinante render "$SRC/examples/demo/demo.cell.toml" "$SRC/examples/demo/session.mcap" --at 7.88 --size 320x240 "$@"; }
mesa=$(draw --hash --json | sed -n 's/^ *"renderer": ".*-mesa\([0-9]*\.[0-9]*\).*/\1/p')
bits=different
[ "$(printf '%s\n25.1\n' "$mesa" | sort -V | sed -n 1p)" = "$mesa" ] || bits=same
for camera in overview arm gantry top; do
  draw --camera "$camera" -o "$camera.here.png"
  draw --camera "$camera" --caps sse2 -o "$camera.there.png"
  found=$(rocinante golden compare "$camera.here.png" "$camera.there.png" --quiet | sed 's/:.*//') || true
  [ "$found" = $bits ] && echo "exact: as this Mesa must" || echo "exact: $found, with Mesa $mesa"
  rocinante golden compare "$camera.here.png" "$camera.there.png" --quiet --tier cpu | sed 's/:.*//'
  LP_NUM_THREADS=1 draw --camera "$camera" -o "$camera.one.png"
  LP_NUM_THREADS=4 draw --camera "$camera" -o "$camera.four.png"
  rocinante golden compare "$camera.here.png" "$camera.one.png" --quiet | sed 's/:.*//'
  rocinante golden compare "$camera.here.png" "$camera.four.png" --quiet | sed 's/:.*//'
done
