# A full disk and a read-only folder are named, and nothing that was accepted is lost.
export ROCINANTE_USER=ada
unshare -m true 2>/dev/null || { echo "skipped: no mount namespace to fill a disk in"; exit 77; }
box() {
  cat >box.urdf <<URDF
<robot name="box"><link name="body"><visual><geometry><box size="1 1 $1"/></geometry></visual></link></robot>
URDF
}
cat >suite.toml <<'TOML'
format = 1
cell = "box.urdf"
[defaults]
size = [160, 120]
[[case]]
name = "a"
[[case]]
name = "b"
hide = ["layer/grid"]
TOML
cat >inside.sh <<'INSIDE'
try() { rocinante golden "$@" --jobs 1 2>&1 | sed '/^    /d; /^why/d'; echo "exit ${PIPESTATUS[0]}"; }
approve() { rocinante golden approve suite.toml "$@" 2>&1 | sed 's/staged-[0-9]*/staged-PID/'; echo "exit ${PIPESTATUS[0]}"; }
mkdir goldens out
mount -t tmpfs -o size=64k tmpfs goldens
mount -t tmpfs -o size=8k tmpfs out
box 1
approve -m first
cp -r goldens before
box 2
# No room for the new pictures: the old ones stay, and so does the manifest.
head -c 1M /dev/zero >goldens/ballast 2>/dev/null
approve -m second
rm goldens/ballast
diff -r before goldens && echo "nothing lost"
try run suite.toml --report out | sed 's/[0-9]* differing/N differing/'
mount -o remount,ro goldens
approve -m third
diff -r before goldens && echo "nothing lost"
INSIDE
{ declare -f box; cat inside.sh; } >all.sh
unshare -m bash all.sh
