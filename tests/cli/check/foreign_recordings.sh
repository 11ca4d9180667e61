# What other programs recorded is checked as it is: imported once, and kept in the cache of the user, not beside the file.
cat >arm.urdf <<'URDF'
<robot name="arm">
  <link name="base"/> <link name="upper"/> <link name="hand"/>
  <joint name="shoulder" type="revolute"> <parent link="base"/> <child link="upper"/>
    <axis xyz="0 0 1"/> <limit lower="-2" upper="2" effort="1" velocity="9"/> </joint>
  <joint name="elbow" type="revolute"> <parent link="upper"/> <child link="hand"/>
    <axis xyz="0 1 0"/> <limit lower="-1.5" upper="1.5" effort="1" velocity="9"/> </joint>
</robot>
URDF
check() { rocinante check "$@" && echo fits || echo "exit $?"; }
printf 't,shoulder,elbow\n0,0.1,0.2\n0.1,0.11,0.2\n0.2,0.12,0.2\n' >fits.csv
printf 't,elbow,shoulder\n0,100,100\n0.1,95,100\n0.2,90,100\n' >percent.csv
printf '{"t":0,"shoulder":90,"elbow":45}\n{"t":0.1,"shoulder":91,"elbow":45}\n' >degrees.jsonl
printf '{"t":0,"shoulder":0,"elbow":0}\n{"t":0.1,"shoulder":2.5,"elbow":0,"wrist":1}\nno JSON\n' >wrong.jsonl
for file in fits.csv percent.csv degrees.jsonl wrong.jsonl; do check arm.urdf $file; done
ls "$XDG_CACHE_HOME"/rocinante/imports | grep -c mcap
check arm.urdf fits.csv --quiet
ls "$XDG_CACHE_HOME"/rocinante/imports | grep -c mcap
# A damaged one is made anew.
for log in "$XDG_CACHE_HOME"/rocinante/imports/*.mcap; do printf 'x' | dd of="$log" bs=1 seek=40 conv=notrunc 2>/dev/null; done
check arm.urdf percent.csv --quiet
# Without a cell, and without a place to keep it.
check fits.csv
mkdir shut && cp fits.csv shut && chmod a-w shut
export XDG_CACHE_HOME=$PWD/fits.csv
check arm.urdf shut/fits.csv --quiet 2>&1 | sed "s#$PWD/##"
chmod u+w shut
