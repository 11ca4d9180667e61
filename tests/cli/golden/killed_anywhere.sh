# Killed before any step that changes the disk, an approval leaves of each golden the old one or the new one, whole;
# the next one clears what they left.
export ROCINANTE_USER=ada
box() {
  cat >box.urdf <<URDF
<robot name="box"><link name="body"><visual><geometry><box size="1 1 $1"/></geometry></visual></link></robot>
URDF
}
cat >suite.toml <<'TOML'
format = 1
cell = "box.urdf"
goldens = "killed"
[defaults]
size = [64, 48]
samples = 1
[[case]]
name = "a"
[[case]]
name = "b"
hide = ["layer/grid"]
TOML
bin=$(dirname "$(command -v rocinante)")
approve() {
  # A sanitizer wants to be loaded first, and can do without.
  ASAN_OPTIONS=${ASAN_OPTIONS:+$ASAN_OPTIONS:}verify_asan_link_order=0 \
    LD_PRELOAD=$bin/../lib/libgolden_kill_shim.so ROCINANTE_TEST_KILL_UNDER=killed ROCINANTE_TEST_KILL_AT=$1 \
    rocinante-golden approve suite.toml -m "killed at $1" >/dev/null 2>&1
}
box 1
rocinante golden approve suite.toml -m first >/dev/null
step=1 status=137
while [ $status = 137 ]; do
  box $((step % 7 + 2))
  status=0
  approve $step || status=$?
  rocinante golden list suite.toml --verify >listed.txt || [ $? = 1 ]
  grep -v 'left by an interrupted approve\| faults' listed.txt | grep 'golden .* is\|cannot' || [ $? = 1 ]
  step=$((step + 1))
done 2>/dev/null  # where the shell tells of what was killed
[ $step -gt 8 ] && echo "killed before each of its steps; the last one ends with $status"
box 1
rocinante golden approve suite.toml -m last | tail -1
rocinante golden list suite.toml --verify | tail -1
ls -A killed | sed 's/\.[0-9a-f]\{8\}\./.HASH./'
