# CTest takes the pictures of a failing suite into its results, which CDash shows over one another.
export ROCINANTE_USER=ada
cat >plate.urdf <<'URDF'
<robot name="plate"><link name="body"><visual><geometry><box size="1 1 0.1"/></geometry></visual></link></robot>
URDF
cat >suite.toml <<'TOML'
format = 1
cell = "plate.urdf"
[[case]]
name = "at-rest"
size = [160, 120]
[[case]]
name = "from-above"
camera = "map"
size = [160, 120]
TOML
rocinante golden approve suite.toml -m first >/dev/null
sed -i 's/1 1 0.1/1 1.2 0.1/' plate.urdf
# Only the lines for CTest; the exit code.
told() {
  "$@" >said || echo "exit $?"
  sed -n "s|$PWD|HERE|; /^<Dart/p" said
}
echo "== asked for"
told rocinante golden run suite.toml --report out --cdash
echo "== not otherwise"
told rocinante golden run suite.toml --report out
echo "== in a dashboard's test"
export DASHBOARD_TEST_FROM_CTEST=3.25
told rocinante golden run suite.toml --report out --only at-rest
rocinante golden run suite.toml --report out --json - >said || echo "exit $?"
python3 -m json.tool said >/dev/null && echo "JSON stays JSON"
unset DASHBOARD_TEST_FROM_CTEST
python3 - <<'PY'
import struct
data = open("out/differences.png", "rb").read()
print("differences.png is", *struct.unpack(">II", data[16:24]))
PY
echo "== what CTest makes of it"
mkdir build
cat >build/CTestTestfile.cmake <<CMAKE
add_test(plate "$(command -v rocinante)" golden run "$PWD/suite.toml" --report "$PWD/out")
CMAKE
printf 'BuildDirectory: %s\nSourceDirectory: %s\n' "$PWD/build" "$PWD" >build/DartConfiguration.tcl
(cd build && ctest -D ExperimentalStart -D ExperimentalTest >said 2>&1 || true)
grep -o '<NamedMeasurement[^>]*>' build/Testing/*/Test.xml | grep Image |
  sed 's/.* name="\([^"]*\)".*/\1/' | sort
echo "== refused"
rocinante golden run suite.toml --cdash || echo "exit $?"
