# Faults of a mesh are named with their lines, and an error makes the model incompatible.
cat >part.obj <<'OBJ'
mtllib gone.mtl
v 0 0 0
v 1 0 0
v 0 1 0
f 1 2 3
f 1 2 7
OBJ
cat >cell.toml <<'CELL'
format = 1
[[device]]
name = "part"
model = "part"
[[model]]
name = "part"
obj = "part.obj"
unit = "m"
up = "z"
geometry = "world"
[[model.link]]
name = "base"
groups = ["*"]
CELL
rocinante check cell.toml
