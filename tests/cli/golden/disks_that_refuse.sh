# A full disk, a read-only folder and a limit on files are named, and nothing that was accepted or reported is lost.
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
try() { rocinante golden "$@" --jobs 1 2>&1 | sed '/^    /d; /^why/d' && echo "exit 0" || echo "exit $?"; }
approve() { rocinante golden approve suite.toml "$@" 2>&1 | sed 's/staged-[[:alnum:]]*/staged-NAME/' && echo "exit 0" || echo "exit $?"; }
mkdir goldens out
mount -t tmpfs -o size=64k tmpfs goldens
mount -t tmpfs -o size=8k tmpfs out
box 1
approve -m first
cp -r goldens before
box 2
# No room for the new pictures: the old ones stay, and so does the manifest.
head -c 1M /dev/zero >goldens/ballast 2>/dev/null || true
approve -m second
rm goldens/ballast
diff -r before goldens && echo "nothing lost"
try run suite.toml --report out | sed 's/[0-9]* differing/N differing/'
ls -A out
# An old report stands until the new one is whole.
mkdir reports
mount -t tmpfs -o size=400k tmpfs reports
try run suite.toml --report reports | tail -1
cp -r reports kept
head -c 1M /dev/zero >reports/ballast 2>/dev/null || true
box 3
try run suite.toml --report reports --only b | sed 's/[0-9]* differing/N differing/; s#(.*)#(FILE)#'
rm reports/ballast
diff -r kept reports && echo "the old report stands"
mount -o remount,ro reports
try run suite.toml --report reports --only b | sed 's/[0-9]* differing/N differing/'
(ulimit -f 8; try run suite.toml --report limited --only b | sed 's/[0-9]* differing/N differing/; s#(.*)#(FILE)#'; ls -A limited)
# No room for the manifest: the pictures were written, and go again.
room=$(($(df --output=avail -B1 goldens | tail -1) - 12288))
head -c "$room" /dev/zero >goldens/ballast
approve -m second --only a | tail -1
rm goldens/ballast
diff -r before goldens && echo "nothing lost"
mount -o remount,ro goldens
approve -m third
diff -r before goldens && echo "nothing lost"
INSIDE
{ declare -f box; cat inside.sh; } >all.sh
unshare -m bash -eu -o pipefail all.sh
