# needs: shared
# A real arm: its tree, its joints, and the names that scripts rely on.
cp -r "$SHARED/robots/kuka_iiwa" . && cd kuka_iiwa
rocinante model info model.urdf
rocinante model tree model.urdf --ascii
rocinante model info model.urdf --json | python3 -c '
import json, sys
info = json.load(sys.stdin)
print(list(info))
print(info["name"], len(info["links"]), info["movable"], info["triangles"], info["textures"], info["meshes_missing"])
print(list(info["joints"][0]), info["bounds_m"].keys())'
