# Every kind of fault is shown once, with its place and a hint.
rocinante spy 127.0.0.1:0 --duration 60s >report 2>said &
spy=$!
until grep -qs '^listening' said; do kill -0 $spy; sleep 0.05; done
port=$(sed 's/.*:\([0-9]*\)$/\1/' said)
exec 3<>"/dev/udp/127.0.0.1/$port"  # one socket: one sender
send() { printf "$1" >packet; cat packet >&3; }
send 'RK2 me - -\njoints a 1 2\n'
send 'RK1 arm@r 0 -\njoints a 1,0 2\norder b x y\njoints b 1 2 3\nwobble 3\n'
send 'RK1 arm@r 1 -\njoints a 1.0 2\npose a 0 0 0 1 0 0 0 0\npose a 0 0 0 0 0 0 0\n'
send 'RK1 cam - -\njoint a j1=0.5\nevent "x\n'
sleep 2.5  # the silence that it is to tell of
kill -INT $spy
wait $spy
# Times and ports differ from run to run.
sed -e "s/:$port/:PORT/; s/127.0.0.1:[0-9][0-9]*/SENDER/g; s/[0-9.]* s\>/TIME/g; s/  */ /g" report
