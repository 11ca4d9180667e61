# --preset ci: what a robot cannot have done fails a job that nobody watches. --rule is above it.
cat >arm.urdf <<'URDF'
<robot name="arm">
  <link name="base"/> <link name="upper"/>
  <joint name="shoulder" type="revolute"> <parent link="base"/> <child link="upper"/>
    <axis xyz="0 0 1"/> <limit lower="-2" upper="2" effort="1" velocity="1"/> </joint>
</robot>
URDF
awk 'BEGIN { print "t,shoulder"; for (i = 0; i < 100; i++) print i / 20 "," (i == 50 ? 1.5 : 0) }' >jump.csv
check() { rocinante check arm.urdf jump.csv "$@" && echo "exit 0" || echo "exit $?"; }
check
check --preset ci --quiet
check --preset ci --rule joint.jump=warning --quiet
check --preset ci --rule joint.jump=off --quiet
# A job's own name for a purpose that does not exist.
check --preset CI 2>&1 | sed -n 1p
