# Three datagrams, each from its own socket, are all in the summary.
rocinante record 127.0.0.1:0 -o log.mcap --json >summary.json 2>said &
recorder=$!
until grep -qs '^recording' said; do sleep 0.05; done
sed 's/:[0-9]* to/:PORT to/' said
port=$(sed 's/.*:\([0-9]*\) to .*/\1/' said)
# One write is one datagram; bash itself would write line by line.
printf 'RK1 arm@run 0 12.5\njoints arm 1 2 3\n' >first
printf 'RK1 arm@run 1 12.6\njoints arm 1 2 4\n' >second
printf 'no packet' >third
for datagram in first second third; do cat $datagram >/dev/udp/127.0.0.1/"$port"; done
kill -INT $recorder
wait $recorder
sed -e "s/:$port\"/:PORT\"/" -e 's/"bytes": [0-9]*/"bytes": N/' -e 's/_bytes": [0-9]*/_bytes": N/' -e 's/"\(start\|end\)": "[^"]*"/"\1": "TIME"/' -e 's/"\(duration\|first_after\)_s": [0-9.e-]*/"\1_s": T/' summary.json
