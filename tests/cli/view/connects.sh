# A window connects, shows a log while the live session goes on behind it, goes back to it and disconnects; what was kept
# is not lost unasked. Bad endpoints are lines over the picture, and what is shown stays.
export ASAN_OPTIONS=detect_leaks=0 XDG_CACHE_HOME=$PWD/cache
demo=$SRC/examples/demo
port=$((20000 + $$ % 20000))
rocinante source --demo all --duration 300s --to "127.0.0.1:$port" >/dev/null 2>&1 &
source=$!
cat >script.txt <<SCRIPT
connect 127.0.0.1:$port
await 1s
drop $demo/session.mcap
await-files
await-line live behind this
panels off
seek 5s
frame 2
screenshot log.png
disconnect
await-line what the session that goes on behind this kept would be deleted: \`live\` shows it; \`save\` what you need
live
await 1.5s
disconnect
await-line what this session kept would be deleted: \`save\` what you need, then \`disconnect forget\`
connect 127.0.0.1:$port
await-line this window listens at 127.0.0.1:$port already
connect :$port
await-line this window listens at that port itself
save saved.mcap
await-line saved: saved.mcap (
disconnect forget
await-line disconnected from udp://127.0.0.1:$port; what it kept is deleted:
dismiss
panels off
frame 2
screenshot rest.png
live
await-line no live session goes on behind what is shown
disconnect
await-line this window listens nowhere
quit
SCRIPT
look() { with_display rocinante view "$@" --size 320x240 --profile reproducible --script script.txt; }
look "$demo/demo.cell.toml" 2>said
sed "s/$port/PORT/g" said
rocinante log doctor saved.mcap >/dev/null && echo sound
ls cache/rocinante/live
printf 'panels off\nseek 5s\nframe 2\nscreenshot log-alone.png\nquit\n' >script.txt
look "$demo/demo.cell.toml" "$demo/session.mcap"
rocinante golden compare log.png log-alone.png
printf 'panels off\nframe 2\nscreenshot rest-alone.png\nquit\n' >script.txt
look "$demo/demo.cell.toml"
rocinante golden compare rest.png rest-alone.png
# From an empty window, without a cell; a cell that is opened takes the session along.
cat >script.txt <<SCRIPT
connect 127.0.0.1:$port
await 1s
save bare.mcap
drop $demo/demo.cell.toml
await-files
await 2s
quit
SCRIPT
look 2>said
sed "s/$port/PORT/g" said
rocinante log doctor bare.mcap >/dev/null && echo sound
kill $source
wait $source 2>/dev/null || true
# What cannot be listened at.
cat >script.txt <<'SCRIPT'
connect nonsense
await-line an endpoint needs a port, as in HOST:19960 (nonsense)
connect http://127.0.0.1:80
connect 127.0.0.1:70000
connect [::1%nowhere]:5
connect udp://239.1.2.3:5000?interface=nowhere7
await-line there is no network interface nowhere7
connect pcap:///gone.pcap
disconnect everything
SCRIPT
look "$demo/demo.cell.toml" 2>&1 | sed 's/; there are .* (udp/; there are ... (udp/' || echo "exit $?"
