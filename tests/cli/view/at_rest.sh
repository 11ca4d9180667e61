# A window whose machine cannot hold the frame rate draws less while the log plays; at rest it shows everything, pixel
# for pixel, and then spends next to nothing.
command -v xdotool >/dev/null || { echo "skipped: no xdotool"; exit 77; }
command -v xwd >/dev/null || { echo "skipped: no xwd (x11-apps)"; exit 77; }
export ASAN_OPTIONS=detect_leaks=0
demo=$SRC/examples/demo
cat >xwd_to_png.py <<'PYTHON'
import struct, sys, zlib
dump = open(sys.argv[1], "rb").read()
head = struct.unpack(">25I", dump[:100])
offset, width, height, order, depth_bits, stride, colors = head[0], head[4], head[5], head[7], head[11], head[12], head[19]
assert depth_bits == 32 and order == 0, "not 32 bits, least significant first"
rows = dump[offset + 12 * colors:]
raw = b"".join(b"\0" + b"".join(bytes((row[i + 2], row[i + 1], row[i], 255)) for i in range(0, 4 * width, 4))
               for row in (rows[y * stride:(y + 1) * stride] for y in range(height)))
def chunk(kind, data):
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
with open(sys.argv[2], "wb") as out:
    out.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 6, 0, 0, 0)) +
              chunk(b"IDAT", zlib.compress(raw)) + chunk(b"IEND", b""))
PYTHON
printf 'panels off\nplay\nwait 2\nframe 2\nscreenshot whole.png\nquit\n' >script.txt
cat >person.sh <<'PERSON'
view() { rocinante view "$demo/demo.cell.toml" "$demo/session.mcap" --size 640x400 "$@"; }
# Until the end of the log, for nothing may move later.
view --at -0.5s --detail 0 --style shadows --style contact --script script.txt
view --at -0.5s --target-fps 240 --frame-times frames.csv 2>view.txt &
viewer=$!
window=$(xdotool search --sync --onlyvisible --name '^Rocinante')
xdotool key --window 0 space
for turn in $(seq 300); do
  # The panels tell what is drawn; without them the picture alone is left. It shows the end when playing is over.
  [ $turn = 10 ] && xdotool key --window 0 Tab
  xwd -silent -id "$window" -out window.xwd && python3 xwd_to_png.py window.xwd window.png
  rocinante golden compare window.png whole.png --tier exact --quiet >compared.txt 2>&1 && break
  kill -0 $viewer || { cat view.txt; exit 1; }
  sleep 0.2
done
sed 's/^same:.*/at rest: everything/' compared.txt
ticks() { awk '{print $14 + $15}' /proc/$viewer/stat; }
sleep 2
before=$(ticks)
sleep 3
spent=$(($(ticks) - before))
[ $spent -le 30 ] && echo "at rest: idle" || echo "at rest: $spent of 300 ticks"
xdotool key --window 0 q
wait $viewer
echo "view: exit $?"
head -n 1 frames.csv
# Every line has all fields; some frames drew the scene, the last one shows the whole picture.
awk -F, 'NR > 1 { if (NF != 11) bad = 1; if ($5 == 1) ++drawn; whole = $7 }
  END { print bad || !drawn ? "frames: wrong" : "frames: written", "whole:", whole }' frames.csv
PERSON
export demo
with_display bash person.sh
