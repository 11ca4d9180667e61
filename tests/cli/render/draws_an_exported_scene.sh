# What `log export --gltf` writes, read again and drawn in the same light, is the same picture, but
# for gloss, which glTF's roughness does not bring back.
cp -r "$SRC/examples/demo" demo
chmod -R u+w demo
sed -i '/^Ks\|^Ns/d' demo/*.mtl demo/arm/*.mtl
sed -i 's/"labels"/"signs_of_the_hall"/' demo/demo.cell.toml
rocinante log export demo/session.mcap demo/demo.cell.toml --gltf --from 11s -o scene.glb 2>/dev/null
{
  sed '/^\[\[layer\]\]/,$d' demo/demo.cell.toml
  sed -n '/^\[\[camera\]\]/,/^\[\[source\]\]/p' demo/demo.cell.toml | sed '/^\[\[source\]\]/d; s/^on = .*/on = "scene"/'
  printf '[[device]]\nname = "scene"\nmodel = "scene.glb"\n'
} >scene.cell.toml
for camera in overview arm top; do
  rocinante render demo/demo.cell.toml demo/session.mcap --at 11s --camera $camera --no-insets \
    --hide layer/lines --hide layer/labels --hide layer/points -o there.$camera.png
  rocinante render scene.cell.toml --camera $camera -o here.$camera.png
  rocinante golden compare here.$camera.png there.$camera.png --tier cpu >verdict || true
  echo "$camera: $(head -n 1 verdict)"
done
