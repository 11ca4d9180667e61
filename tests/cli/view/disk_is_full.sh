# Where Mesa's cache of shaders and the kept log belong, the disk is full: pictures are drawn all the same.
export ASAN_OPTIONS=detect_leaks=0
unshare -m true 2>/dev/null || { echo "skipped: no mount namespace to fill a disk in"; exit 77; }
demo=$SRC/examples/demo
port=$((20000 + ($$ + 11) % 20000))
export XDG_CACHE_HOME=$PWD/cache demo port
printf 'panels off\nframe 2\nscreenshot window.png\nquit\n' >script.txt
cat >inside.sh <<'INSIDE'
mkdir cache
mount -t tmpfs -o size=64k tmpfs cache
head -c 1M /dev/zero >cache/ballast 2>/dev/null || true
rocinante render "$demo/demo.cell.toml" --size 64x48 --samples 1 -o pinned.png && echo "render: exit 0"
rocinante render "$demo/demo.cell.toml" --size 64x48 --samples 1 --profile fast -o fast.png && echo "fast: exit 0"
with_display rocinante view "$demo/demo.cell.toml" --live "127.0.0.1:$port" --size 640x400 --script script.txt 2>&1 && echo "view: exit 0"
[ -s pinned.png ] && [ -s fast.png ] && [ -s window.png ] && echo "drawn"
INSIDE
unshare -m bash -eu inside.sh
