# A bag is drawn as the log that `log import` makes of it.
cp -r "$SRC/examples/demo" demo && cd demo
rocinante log export motion.mcap demo.cell.toml --ros2 -o bag.mcap >/dev/null 2>&1
rocinante log import bag.mcap --cell demo.cell.toml -o imported.mcap >/dev/null 2>&1
for log in bag.mcap imported.mcap bag.mcap; do
  rocinante render demo.cell.toml $log --at 5 --size 160x120 --hash 2>/dev/null
done | uniq -c | sed 's/[0-9a-f]\{64\}/HASH/; s/^ *//'
ls "$XDG_CACHE_HOME"/rocinante/imports | grep -c '\.mcap$'
# Whatever the file is called, and without a log beside the cell.
mv bag.mcap bag.bin
rocinante render demo.cell.toml bag.bin --every 10s --sheet sheet.png --size 160x120 2>/dev/null && ls sheet.png
rocinante render demo.cell.toml --at 1 -o frame.png || echo "exit $?"
