# The unit as it is installed: systemd takes it, and its exposure is at most 2.0 of 10.
command -v systemd-analyze >/dev/null || { echo "skipped: no systemd-analyze"; exit 77; }
build=$(dirname "$(command -v rocinante)")/..
mkdir usr
cmake -DCMAKE_INSTALL_PREFIX="$PWD/usr" -P "$build/share/systemd/cmake_install.cmake" >installed
mkdir usr/bin
ln -s "$(command -v rocinante-check)" usr/bin
unit=usr/lib/systemd/system/rocinante-check@.service
grep -q "^ExecStart=$PWD/usr/bin/rocinante-check " $unit
# The machine's own units are none of this test's business.
systemd-analyze verify --man=no --recursive-errors=no $unit
systemd-analyze security --offline=true --threshold=20 --no-pager "$PWD/$unit" >security || { tail -n 1 security; exit 1; }
! grep -q 'Failed to\|Unknown' security
# Its settings are words that the program takes.
printf '<robot name="arm"><link name="base"/></robot>' >arm.urdf
CELL=arm.urdf LIVE= OPTIONS=
eval "$(sed -n 's/^\(LIVE\|OPTIONS\)=\(.*\)/\1="\2"/p' usr/share/rocinante/check-service.conf)"
rocinante check $CELL ${LIVE/:19960/127.0.0.1:0} --watch $OPTIONS --duration 100ms 2>/dev/null || echo "exit $?"
