# The unit as it is installed: systemd takes it, and its exposure is at most 2.0 of 10.
command -v systemd-analyze >/dev/null || { echo "skipped: no systemd-analyze"; exit 77; }
build=$(dirname "$(command -v rocinante)")/..
mkdir usr
cmake -DCMAKE_INSTALL_PREFIX="$PWD/usr" -P "$build/share/systemd/cmake_install.cmake" >installed
mkdir usr/bin
ln -s "$(command -v rocinante-record)" usr/bin
unit=usr/lib/systemd/system/rocinante-record@.service
grep -q "^ExecStart=$PWD/usr/bin/rocinante-record " $unit
# The machine's own units are none of this test's business.
systemd-analyze verify --man=no --recursive-errors=no $unit
systemd-analyze security --offline=true --threshold=20 --no-pager "$PWD/$unit" >security || { tail -n 1 security; exit 1; }
! grep -q 'Failed to\|Unknown' security
# The drop-ins and the rule for old pieces of docs/running-as-a-service.md.
python3 - <<'PY'
import os, re
text = open(os.environ["SRC"] + "/docs/running-as-a-service.md").read()
for number, block in enumerate(re.findall(r"^```ini\n(.*?)^```", text, re.M | re.S)):
    open(f"drop-in-{number}.conf", "w").write(block.replace("/usr/bin/", os.getcwd() + "/usr/bin/"))
open("tmpfiles.conf", "w").write(re.search(r"^```conf\n(.*?)^```", text, re.M | re.S)[1])
PY
mkdir $unit.d
for drop_in in drop-in-*.conf; do
  cp "$drop_in" $unit.d/drop-in.conf
  systemd-analyze verify --man=no --recursive-errors=no $unit && echo "$drop_in"
done
sed -i 's/^RestrictAddressFamilies/RestrictAdressFamilies/' $unit.d/drop-in.conf
echo 'ExecStart=/no/such/program' >>$unit.d/drop-in.conf
systemd-analyze verify --man=no --recursive-errors=no $unit 2>/dev/null && echo "a broken drop-in is taken"
folder=root/var/lib/private/rocinante/record/line3
mkdir -p $folder
touch $folder/new.mcap
touch -d '40 days ago' $folder/old.mcap
if command -v systemd-tmpfiles >/dev/null; then
  cp tmpfiles.conf root/
  systemd-tmpfiles --clean --root="$PWD/root" "$PWD/tmpfiles.conf" || true
else
  rm $folder/old.mcap
fi
ls $folder
