# A cell of several devices: each of them, each model once; and one device alone.
cd "$SRC/examples/demo"
rocinante model info demo.cell.toml
LC_ALL=C.UTF-8 rocinante model tree demo.cell.toml --device gantry
rocinante model info demo.cell.toml --device arm --json | python3 -c '
import json, sys
info = json.load(sys.stdin)
print(info["name"], info["links"], [d["name"] for d in info["devices"]])'
