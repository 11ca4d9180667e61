# A picture without the texture that its model names is no golden unless somebody insists; every run names what it lacks.
export ROCINANTE_USER=ada
python3 - <<'P'
import struct, zlib
def part(kind, data): return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
open("skin.png", "wb").write(b"\x89PNG\r\n\x1a\n" + part(b"IHDR", struct.pack(">IIBBBBB", 1, 1, 8, 2, 0, 0, 0)) + part(b"IDAT", zlib.compress(b"\0\xff\0\0")) + part(b"IEND", b""))
P
printf 'newmtl skin\nmap_Kd skin.png\nnewmtl spare\nmap_Kd spare.png\n' >box.mtl
printf 'mtllib box.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nusemtl skin\nf 1/1 2/2 3/3\n' >box.obj
cat >robot.urdf <<'URDF'
<robot name="robot"><link name="body"><visual><geometry><mesh filename="box.obj"/></geometry></visual></link></robot>
URDF
printf 'format = 1\ncell = "robot.urdf"\n[[case]]\nname = "it"\nsize = [64, 48]\n' >suite.toml
do_it() { local status=0; rocinante golden "$@" >said 2>&1 || status=$?; sed "s/llvmpipe-[^ ]*/KEY/g" said; echo "exit $status"; }
echo "== a texture that nothing is drawn with"
do_it approve suite.toml -m first
do_it run suite.toml --jobs 1
echo "== the file is gone"
mv skin.png away.png
do_it run suite.toml --jobs 1 --report report
grep -o '"lacks":\[[^]]*\]' report/report.json || python3 -c 'import json; print(json.load(open("report/report.json"))["frames"][0]["lacks"])'
do_it approve suite.toml -m worse
python3 -c 'import json; f = json.load(open("report/report.json"))["frames"][0]; print(f["name"], f["pixels"], sep="\t")' >list
do_it approve suite.toml -m worse --artifact report --from list
do_it approve suite.toml -m 'it is meant' --anyway
do_it run suite.toml --jobs 2
do_it approve suite.toml -m 'again'
echo "== it is back"
mv away.png skin.png
do_it run suite.toml --jobs 1
echo "== a pointer to a file, no picture"
do_it approve suite.toml -m back
printf 'version https://git-lfs.github.com/spec/v1\n' >skin.png
do_it run suite.toml --jobs 1
do_it approve suite.toml -m pointer
