# What no picture of a suite can show is named once, by the first of its kind.
cat >points.gltf <<'GLTF'
{"asset":{"version":"2.0"},"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0}},{"attributes":{"POSITION":0},"mode":0},
{"attributes":{"POSITION":0},"mode":1}]}],
"accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"}],
"bufferViews":[{"buffer":0,"byteLength":36}],
"buffers":[{"byteLength":36,"uri":"data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}]}
GLTF
printf 'format = 1\ncell = "points.gltf"\n[defaults]\nsize = [32, 24]\n[[case]]\nname = "one"\n' >points.suite.toml
rocinante golden run points.suite.toml 2>&1 || echo "exit $?"
