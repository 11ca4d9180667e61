# What befalls the kept log of a live window is a sentence over the picture, and the window continues live: its disk is
# full, someone deletes it, there is no folder for it.
export ASAN_OPTIONS=detect_leaks=0
unshare -m true 2>/dev/null || { echo "skipped: no mount namespace to fill a disk in"; exit 77; }
cat >box.urdf <<'URDF'
<robot name="box"><link name="body"><visual><geometry><box size="1 1 1"/></geometry></visual></link></robot>
URDF
cat >source.py <<'PYTHON'
# Poses that no compression makes small, until it is killed.
import random, socket, sys, time
out = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
number = 0
while True:
    for _ in range(20):
        x, y = random.random(), random.random()
        out.sendto(f"RK1 box@run {number} -\npose box {x} {y} 0 0 0 0 1\n".encode(), ("127.0.0.1", int(sys.argv[1])))
        number += 1
    time.sleep(0.02)
PYTHON
# What the window waits for, once its log is kept; the shell does the harm at `kept.png`.
view() {
  port=$((20000 + ($$ + 17) % 20000))
  rm -f kept.png
  rocinante view box.urdf --live "127.0.0.1:$port" --size 320x240 --script "$1" >said.txt 2>&1 &
  viewer=$!
  python3 source.py "$port" &
  source=$!
}
harm() {
  until [ -s kept.png ]; do
    kill -0 $viewer || exit 1
    sleep 0.05
  done
}
end() {
  wait $viewer && echo "$1: said, exit 0" || echo "$1: exit $?"
  kill $source
  wait $source 2>/dev/null || true
  sed "/shader cache/d; s|$PWD|HERE|g" said.txt
}
export -f view harm end
cat >inside.sh <<'INSIDE'
mkdir full
mount -t tmpfs -o size=2M tmpfs full
export XDG_CACHE_HOME=$PWD/full
printf 'await 1s\nscreenshot kept.png\nawait-line this session is no longer kept: \nawait-line No space left on device\nframe 2\n' >script.txt
view script.txt
harm
head -c 4M /dev/zero >full/ballast 2>/dev/null || true
end "disk full"

export XDG_CACHE_HOME=$PWD/deleted
printf 'await 1s\nscreenshot kept.png\nawait-line this session is no longer kept\nframe 2\n' >script.txt
view script.txt
harm
rm -r deleted/rocinante/live
end "deleted"

export XDG_CACHE_HOME=$PWD/box.urdf
printf 'await-line cannot make the folder\nframe 1\nscreenshot kept.png\nframe 2\n' >script.txt
view script.txt
end "no folder"
INSIDE
with_display unshare -m bash -eu inside.sh
