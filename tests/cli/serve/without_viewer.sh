# Without the viewer of pages a live session is served to Foxglove clients all the same; a log, which
# nothing else can show, is not.
mkdir -p elsewhere/bin
cp "$(command -v rocinante-serve)" elsewhere/bin/
export PYTHONPATH=$SRC/tests/serve
python3 - "$SRC/examples/demo" <<'PY'
import re
import signal
import subprocess
import sys
import urllib.request
from web_socket import WebSocket

demo = sys.argv[1]
serve = subprocess.Popen(["elsewhere/bin/rocinante-serve", f"{demo}/demo.cell.toml", "--live", "127.0.0.1:0",
                          "--listen", "127.0.0.1:0"], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
for line in serve.stderr:
    print(re.sub(r"; web.rocinante-viewer.js is not in .*|:\d+/?", "", line).strip())
    if line.startswith("serving"):
        port = int(re.search(r"http://127\.0\.0\.1:(\d+)/", line).group(1))
        break
print(urllib.request.urlopen(f"http://127.0.0.1:{port}/").read().decode().splitlines()[1])
print("Foxglove:", "serverInfo" in WebSocket(port, "foxglove.sdk.v1").message())
serve.send_signal(signal.SIGINT)
print(serve.communicate(timeout=60)[0], end="")
PY
elsewhere/bin/rocinante-serve "$SRC/examples/demo/demo.cell.toml" "$SRC/examples/demo/session.mcap" 2>&1 |
  sed 's/; web.rocinante-viewer.js is not in .*//' || echo "exit $?"
