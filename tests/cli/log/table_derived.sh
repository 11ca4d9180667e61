# What is derived of values is a column in the words of the window's plots; what is none says why.
cat >cell.toml <<'TOML'
format = 1
[[device]]
name = "arm"
model = "arm.urdf"
TOML
cat >arm.urdf <<'URDF'
<robot name="arm"><link name="base"/><link name="tip"/>
<joint name="lift" type="prismatic"><parent link="base"/><child link="tip"/><axis xyz="0 0 1"/>
<limit lower="0" upper="9" effort="1" velocity="1"/></joint></robot>
URDF
make_pcap s.pcap \
  '0:whole:RK1 arm@a 0 -\njoint arm lift=0\nsignal arm load 5 kg\nsignal arm mode "auto"\n' \
  '500:whole:RK1 arm@a 1 -\njoint arm lift=1\n' \
  '1000:whole:RK1 arm@a 2 -\njoint arm lift=1\nsignal arm load 7 kg\n' \
  '1500:whole:RK1 arm@a 3 -\njoint arm lift=3\n'
rocinante log import s.pcap -o s.mcap --cell cell.toml
rocinante log table s.mcap --derive 'd/dt arm.lift' --derive 'mean 1 signal arm load' \
  --derive 'arm/tip:z - arm.lift' -o all.csv --json
cat all.csv
rocinante log table s.mcap --derive 'd/dt arm/tip:z' --device other --every 250ms
rocinante log table s.mcap --derive 'd/dt arm.lift' -o all.npz
python3 -c 'import zipfile; print(zipfile.ZipFile("all.npz").namelist())'
echo "== sent again, without them"
rocinante source --csv all.csv --speed 1000 --run r1 --to 127.0.0.1:9 --quiet && echo sent
echo "== refused"
for wrong in 'd/dt signal arm mode' 'd/dt arm.lfit' 'mean nan arm.lift' 'arm.lift' 'd/dt arm/tp:z'; do
  rocinante log table s.mcap --derive "$wrong" || echo "exit $?"
done
