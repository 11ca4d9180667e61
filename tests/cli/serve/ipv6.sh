# IPv6 addresses are listened on, named in URLs and accepted as Host.
export PYTHONPATH=$SRC/tests/serve
python3 -c 'import socket; socket.create_server(("::1", 0), family=socket.AF_INET6)' 2>/dev/null ||
  { echo "skipped: there is no IPv6 on this machine"; exit 77; }
python3 - "$SRC/examples/demo" <<'PY'
import sys
from serving import Serving

demo = sys.argv[1]
serving = Serving(f"{demo}/demo.cell.toml", f"{demo}/session.mcap", address="[::1]")
print(serving.get("/log")[2] == open(f"{demo}/session.mcap", "rb").read())
print(serving.get("/", "Origin: http://[::1]:%d" % serving.port)[0], serving.get("/", host="evil.example")[0])
print(serving.stop()[1])
PY
