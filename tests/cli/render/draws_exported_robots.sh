# needs: shared
# Real robots, posed by a packet, written as glTF and read again are the same picture.
cp -r "$SHARED/robots/franka_panda" "$SHARED/robots/kuka_iiwa" .
chmod -R u+w .
sed -i '/^Ks\|^Ns/d' franka_panda/meshes/*/*.mtl kuka_iiwa/meshes/*.mtl
python3 - <<'PY'
import os, sys
sys.path.insert(0, os.path.join(os.environ['SRC'], 'tests/support'))
from mcap_file import McapFile
for name, joints in (('panda', '0.3 -0.6 0.2 -2.2 0.1 1.9 0.7 0.03'), ('iiwa', '0.4 0.7 -0.3 -1.4 0.2 0.9 0.5')):
    log = McapFile()
    packet = f'RK1 s 0 -\njoints {name} {joints}\n'
    log.chunk([((1, '/udp/test', 'rk1', {}), 1_700_000_000_000_000_000, packet.encode())])
    log.save(name + '.mcap')
PY
for robot in panda:franka_panda/panda.urdf iiwa:kuka_iiwa/model.urdf; do
  name=${robot%%:*}
  cat >$name.cell.toml <<TOML
format = 1
[scene]
grid = false
[[device]]
name = "$name"
model = "${robot#*:}"
[[camera]]
name = "side"
eye = [1.6, -1.8, 1.3]
target = [0.1, 0, 0.45]
TOML
  sed "s|${robot#*:}|$name.glb|" $name.cell.toml >again.cell.toml
  rocinante log export $name.mcap $name.cell.toml --search franka_panda --gltf -o $name.glb
  rocinante render $name.cell.toml $name.mcap --search franka_panda --at 0 -o there.$name.png 2>said || { cat said; exit 1; }
  rocinante render again.cell.toml -o here.$name.png
  rocinante golden compare here.$name.png there.$name.png --tier cpu >verdict || true
  echo "$name: $(head -n 1 verdict)"
done
