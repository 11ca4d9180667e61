# A clock that was set while it recorded: 53.9 years. A row for each second of them is nobody's wish.
printf 't,arm.j\n5,0.1\n6,0.2\n1700000000,0.3\n' >set.csv
rocinante log import set.csv -o set.mcap | sed 's/ [0-9.]* s;/ N s;/'
rocinante log table set.mcap --every 1s -o set-table.csv || echo "exit $?"
echo '<robot name="r"><link name="a"/></robot>' >arm.urdf
rocinante log export arm.urdf set.mcap --gltf --every 1s -o set.glb || echo "exit $?"
rocinante log table set.mcap --every 1s --until 7s
ls
