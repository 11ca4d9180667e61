# needs: shared
# The models that nobody here made are sound: what they lack are material files, which check names.
for model in puma560_description/urdf/puma560_robot.urdf kuka_iiwa/model.urdf franka_panda/panda.urdf \
  r2d2/r2d2.urdf; do
  rocinante check "$SHARED/robots/$model" --search "$SHARED/robots" --json |
    python3 -c 'import json,sys; r=json.load(sys.stdin); print(r["verdict"], r["errors"], sorted({f["rule"] for f in r["findings"]}))'
done
rocinante check "$SHARED/env/waste_yard/waste_yard.obj" | tail -n 1
