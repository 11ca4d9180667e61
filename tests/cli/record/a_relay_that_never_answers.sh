# What a subscriber ends with when its relay never answered: an error, however short and quiet it was.
# The relay's port is held by a socket that never answers.
cat >silent.py <<'PY'
import socket, time
s = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
s.bind(("127.0.0.1", 0))
print(s.getsockname()[1], flush=True)
time.sleep(300)
PY
python3 silent.py >port &
trap "kill $!" EXIT
until [ -s port ]; do sleep 0.05; done
relay=subscribe://127.0.0.1:$(cat port)
# On a busy machine the relay may be reported as silent first.
plain() { sed -e '/does not answer/d' -e "s/:$(cat port)/:PORT/g" -e 's/([0-9.]* k*B)/(SIZE)/'; }
printf '<robot name="arm"><link name="base"/></robot>' >arm.urdf

echo "# record"
rocinante record "$relay" -o a.mcap --duration 50ms 2>said | plain || echo "exit $?"
plain <said
echo "# record --quiet"
rocinante record "$relay" -o b.mcap --duration 50ms --quiet 2>&1 | plain || echo "exit $?"
echo "# --min-packets is judged too"
rocinante record "$relay" -o c.mcap --duration 50ms --quiet --min-packets 1 2>&1 | plain || echo "exit $?"
echo "# spy"
rocinante spy "$relay" --duration 50ms 2>&1 >/dev/null | plain || echo "exit $?"
echo "# check"
rocinante check arm.urdf --live "$relay" --duration 50ms 2>&1 >/dev/null | plain || echo "exit $?"
echo "# relay"
rocinante relay --from "$relay" --serve 127.0.0.1:0 >/dev/null 2>said &
until grep -qs '^serving' said; do kill -0 $!; sleep 0.05; done
kill -INT $!
wait $! || echo "exit $?"
sed -e 's/^serving.*:.*/serving/' said | plain
