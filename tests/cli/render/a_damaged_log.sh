# Damage between the keyframe that a moment begins with and the moment is named for every frame that depends on it, whatever
# else is drawn; the pictures are written all the same, and the exit code is 1.
cell=$SRC/examples/demo/demo.cell.toml
cp "$SRC/examples/demo/session.mcap" whole.mcap
spoil() { python3 "$SRC/tests/cli/spoil_chunks" "$@"; }
draw() { rocinante render "$cell" "$@" --size 64x48 2>said || echo "exit $?"; sed 's/checksum (.*stored [0-9a-f]*)/checksum/' said; }
damaged() { rocinante render "$cell" "$@" --size 64x48 --json >answer.json 2>said || echo "exit $?"
  python3 -c 'import json; a = json.load(open("answer.json")); print([f["time"] for f in a["frames"] if "damage" in f], len(a["warnings"]))'; }

echo "== every chunk from 10 s on"
spoil whole.mcap half.mcap 10 99
draw half.mcap --at 15.25s -o late.png
draw half.mcap --at 5s -o early.png
ls ./*.png
echo "== alone, in order, shuffled"
for at in 5 9.9 10.3 19.9; do damaged half.mcap --at $at; done
damaged half.mcap --at 5 --at 9.9 --at 10.3 --at 19.9
damaged half.mcap --at 19.9 --at 5 --at 10.3 --at 9.9
echo "== every frame is written"
draw half.mcap --every 4s --frames frames --sheet sheet.png --identity ids.png --depth depth.png
ls frames ids-0000?.png depth-0000?.png sheet.png | wc -l

echo "== a fitted camera looks at the whole session; a panel counts the second before; a trail its window"
damaged half.mcap --at 5 --camera overview
damaged half.mcap --at 5 --camera fit
damaged half.mcap --at 9.9 --at 5 --overlay --trail arm/tip@4s

echo "== events that may be hidden"
draw half.mcap --events --hash | sed 's/^[0-9a-f]\{64\}$/HASH/'
draw half.mcap --event nothing --hash

echo "== nothing can be read"
spoil whole.mcap none.mcap 0 99
draw none.mcap --at 0 --hash | sed 's/^[0-9a-f]\{64\}$/HASH/'
echo "== cut off: what is there is whole"
head -c 150000 whole.mcap >cut.mcap
draw cut.mcap --at 12s -o cut.png
