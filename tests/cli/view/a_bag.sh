# A bag is shown like a log, alone or with a cell, and when it is dropped on the window.
export ASAN_OPTIONS=detect_leaks=0
cp -r "$SRC/examples/demo" demo && cd demo
rocinante log export motion.mcap demo.cell.toml --ros2 -o bag.mcap >/dev/null 2>&1
cat >look <<'SH'
rocinante view demo.cell.toml bag.mcap --size 320x240 --profile reproducible --script script.txt >/dev/null 2>said
echo "exit $?" >code
SH
printf 'panels off\nseek 5s\nframe 2\nevidence evidence.png\nquit\n' >script.txt
with_display bash look 2>/dev/null || true
cat code
ls evidence.png
ls "$XDG_CACHE_HOME"/rocinante/imports | grep -c '\.mcap$'
# A folder that is a bag, too.
mkdir folder && mv bag.mcap folder/bag_0.mcap && touch folder/metadata.yaml
sed -i 's/bag.mcap/folder/' look
rm evidence.png code
with_display bash look 2>/dev/null || true
cat code
ls evidence.png
