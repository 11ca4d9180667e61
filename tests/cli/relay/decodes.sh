# A relay with --decoders passes packets on, to those who know packet text only; what it cannot decode
# it counts.
cat >run.py <<'PY'
import json, signal, socket, subprocess, sys
hear = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
hear.bind(("127.0.0.1", 0))
hear.settimeout(60)
relay = subprocess.Popen(["rocinante", "relay", "--from", "127.0.0.1:0", "--to", f"127.0.0.1:{hear.getsockname()[1]}",
                          "--decoders", sys.argv[1], "--json"], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
port = int(relay.stderr.readline().rsplit(":", 1)[1])
send = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
telegram = ('<Rob Type="KUKA"><AIPos A1="%s" A2="-90.0" A3="90.0" A4="0.0" A5="45.0" A6="180.0"/><Delay D="%d"/></Rob>')
for text in ["neither", telegram % (90, 0), "RK1 a@r 0 17.5\njoints arm 1\n", telegram % (180, 2)]:
    send.sendto(text.encode(), ("127.0.0.1", port))
for _ in range(3):
    head, _, rest = hear.recv(2000).decode().partition("\n")
    words = head.split(" ")
    print(words[0], words[1].split("@")[0], "|", rest.rstrip("\n"))
relay.send_signal(signal.SIGINT)
out, _ = relay.communicate(timeout=60)
print("exit", relay.returncode)
print(json.dumps(json.loads(out)["decoded"], indent=1))
PY
python3 run.py "$SRC/examples/decoders/kuka_rsi.decoders.toml"
sed 's/at = "AIPos@A1"//' "$SRC/examples/decoders/kuka_rsi.decoders.toml" >bad.decoders.toml
rocinante relay --from 127.0.0.1:0 --to 127.0.0.1:9 --decoders bad.decoders.toml || echo "exit $?"
