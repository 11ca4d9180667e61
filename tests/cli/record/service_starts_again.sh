# The unit's ExecStart with its example settings, expanded as systemd does it: it records, SIGHUP begins a piece, SIGTERM
# ends it with 0; killed, and started again and again, it never touches a file that is there.
cat >start.py <<'PY'
import os, re, shlex, sys
settings = dict(line.split("=", 1) for line in open(sys.argv[1]).read().splitlines() if line and not line.startswith("#"))
settings["STATE_DIRECTORY"] = sys.argv[2]
settings["ENDPOINTS"] = "127.0.0.1:0"  # any port
line = re.search(r"^ExecStart=(.*)$", open(os.environ["SRC"] + "/share/systemd/rocinante-record@.service.in").read(), re.M)[1]
words = []
for word in line.split():
    if re.fullmatch(r"\$[A-Z]+", word):
        words += shlex.split(settings[word[1:]])
    else:
        words.append(re.sub(r"\$\{([A-Z_]+)\}", lambda name: settings[name[1]], word))
assert words[0] == "@ROCINANTE_BIN@/rocinante-record", words
if len(sys.argv) > 3:
    print(*words[1:])
else:
    os.execvp("rocinante-record", ["rocinante-record"] + words[1:])
PY
example=$SRC/share/systemd/example.conf
python3 start.py "$example" STATE show
mkdir state
# One start, again as systemd does it where the name of this second is taken.
start() {
  for _ in $(seq 200); do
    rm -f said  # of the one before
    python3 start.py "$example" "$PWD/state" 2>said >summary &
    until grep -qs '^recording' said || ! kill -0 $! 2>/dev/null; do sleep 0.02; done
    if grep -q '^recording' said; then return 0; fi
    code=0
    wait $! || code=$?
    # It refuses, and says which file is there.
    if [ "$code" != 2 ] || ! grep -q "state/[0-9TZ]*.mcap" said; then cat said; exit 1; fi
    sleep 0.1
  done
  exit 1
}
# send N: N packets, and waits until the log has them.
send() {
  python3 - "$1" "$(sed -n 's/^recording udp:..127.0.0.1:\([0-9]*\) to .*/\1/p' said)" <<'PY'
import socket, sys, time
to = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
for i in range(int(sys.argv[1])):
    to.sendto(b"RK1 me@a %d -\njoint arm turn=0.%d\n" % (i, i), ("127.0.0.1", int(sys.argv[2])))
PY
  log=$(sed -n 's/^recording .* to //p' said)
}
has() { [ "$(rocinante log info "$1" --json 2>/dev/null | python3 -c 'import json, sys; print(json.load(sys.stdin)["packets"])')" = "$2" ]; }
wait_until() { for _ in $(seq 400); do if "$@"; then return 0; fi; sleep 0.05; done; echo "never: $*"; exit 1; }

start
send 3
first=$log
kill -TERM $!
wait $! && echo "stopped: exit 0"
has "$first" 3 && echo "first: 3"
before=$(sha256sum "$first")

start
send 2
second=$log
wait_until has "$second" 2
{ kill -KILL $! && wait $!; } 2>/dev/null || true
has "$second" 2 && echo "second, killed: 2"

start
send 4
third=$log
wait_until has "$third" 4
kill -HUP $!
# The next piece begins with the next packet that finds the signal there.
next_piece() { send 1; grep -q 'is written' said; }
third=$log
wait_until next_piece
kill -TERM $!
wait $! && echo "stopped: exit 0"
packets=$(rocinante log info "$third" --json | python3 -c 'import json, sys; print(json.load(sys.stdin)["packets"])')
[ "$packets" -ge 4 ] && echo "third: 4 and those before the next piece"
[ "$before" = "$(sha256sum "$first")" ] && has "$second" 2 && echo "the older ones are as they were"
ls state | wc -l  # one of each start, and the piece
