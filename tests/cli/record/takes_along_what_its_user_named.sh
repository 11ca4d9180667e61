# A stranger's cell names a folder of ours as a root: what is in it does not get into the log, unless the
# command line names that folder too.
mkdir -p home/.ssh home/got
echo secret >home/.ssh/id_rsa
ln -s ../.ssh home/got/keys
cat >home/got/box.urdf <<'URDF'
<robot name="box"><link name="body"><visual><geometry><box size="1 1 1"/></geometry>
<material name="m"><texture filename="id_rsa"/></material></visual></link></robot>
URDF
printf 'format = 1\nsearch = ["keys"]\n[[device]]\nname = "box"\nmodel = "box.urdf"\n' >home/got/a.cell.toml
rocinante record 127.0.0.1:0 --cell home/got/a.cell.toml -o a.mcap --duration 50ms || echo "exit $?"
ls
rocinante record 127.0.0.1:0 --cell home/got/a.cell.toml --search home/.ssh -o a.mcap --duration 50ms --quiet
rocinante log extract a.mcap --list | awk '{print $NF}' | sort
# Meshes beside a folder of models need no option.
mkdir -p robot/urdf robot/meshes
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n' >robot/meshes/part.obj
echo '<robot name="r"><link name="l"><visual><geometry><mesh filename="../meshes/part.obj"/></geometry></visual></link></robot>' >robot/urdf/r.urdf
rocinante record 127.0.0.1:0 --cell robot/urdf/r.urdf -o b.mcap --duration 50ms --quiet
rocinante log extract b.mcap --list | awk '{print $NF}' | sort
