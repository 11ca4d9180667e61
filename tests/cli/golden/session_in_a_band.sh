# `golden session --accepted`: a recording between two accepted ones is the same, one beyond them is not.
cat >arm.urdf <<'URDF'
<robot name="arm">
  <link name="base"/> <link name="upper"><visual><geometry><box size="1 0.2 0.2"/></geometry></visual></link>
  <joint name="shoulder" type="revolute"> <parent link="base"/> <child link="upper"/>
    <axis xyz="0 0 1"/> <limit lower="-2" upper="2" effort="1" velocity="9"/> </joint>
</robot>
URDF
swing() { awk -v add="$1" 'BEGIN { print "t,shoulder"; for (i = 0; i < 100; i++) print i / 20 "," i / 100 + add }' >"$2.csv"; }
swing 0 first
swing 0.02 second
swing 0.01 between
swing 0.05 beyond
told() { grep -E '^(accepted|same|different|incomparable|pictures|  note: no picture|  arm/shoulder)' | sed 's/:.*beyond/: beyond/; s/accepted, .*/accepted/' ; }
judge() { rocinante golden session "$@" | told || echo "exit $?"; }
bare() { judge "$@" --no-pictures; }
bare first.csv between.csv arm.urdf
bare first.csv between.csv arm.urdf --accepted second.csv
bare first.csv beyond.csv arm.urdf --accepted second.csv
# Nothing is drawn of what lies between; of what lies beyond it is.
judge first.csv between.csv arm.urdf --accepted second.csv --size 32x32
judge first.csv beyond.csv arm.urdf --accepted second.csv --size 32x32 | sed 's/[0-9]* of/N of/'
judge first.csv between.csv arm.urdf --accepted none.csv
