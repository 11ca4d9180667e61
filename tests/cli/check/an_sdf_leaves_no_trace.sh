# libsdformat would keep a log of its own in the home folder, and speak of one that it cannot have.
cat >arm.sdf <<'SDF'
<sdf version='1.7'><model name='arm'><link name='base'/><link name='hand'/>
<joint name='turn' type='continuous'><parent>base</parent><child>hand</child><axis><xyz>0 0 1</xyz></axis></joint>
</model></sdf>
SDF
rocinante check arm.sdf >said 2>&1 || true
if grep -q 'without its module' said; then
  echo "skipped: built without ROCINANTE_SDF"
  exit 77
fi
judge() { rocinante check arm.sdf --quiet | tail -n 1; }
mkdir home
HOME=$PWD/home judge
find home -mindepth 1
HOME=/proc/nowhere judge
(unset HOME && judge)
