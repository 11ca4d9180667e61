# A log that the window opens beside the shown one is what --beside shows, to the last pixel, and so is its evidence; ended,
# the picture is that of one session. What cannot be beside it is a line over the picture. A log in place of another offers
# that one, by Y and Enter, and two that are dropped together are beside each other, even while something is loaded.
export ASAN_OPTIONS=detect_leaks=0
demo=$SRC/examples/demo
cp "$demo/session.mcap" 'accepted session.mcap'
look() { with_display rocinante view "$demo/demo.cell.toml" "$demo/session.mcap" --camera overview --size 640x480 \
  --profile reproducible --script script.txt "$@" 2>&1 || echo "exit $?"; }
cat >script.txt <<'SCRIPT'
panels off
seek 0s
parting next
parting next
frame 2
screenshot window.png
evidence evidence.png
beside off
frame 2
screenshot alone.png
quit
SCRIPT
look --beside 'accepted session.mcap' --align 1.5s
cat >script.txt <<'SCRIPT'
panels off
beside accepted%20session.mcap 1.5s
await-files
seek 0s
parting next
parting next
frame 2
screenshot opened.png
evidence opened-evidence.png
beside none
frame 2
screenshot ended.png
beside gone.mcap
await-line there is no such file
dismiss
await-line
beside accepted%20session.mcap 1.5s
parting largest
await-line the largest difference:
quit
SCRIPT
look
rocinante golden compare window.png opened.png
rocinante golden compare evidence.png opened-evidence.png
rocinante golden compare alone.png ended.png
cat >script.txt <<SCRIPT
drop accepted%20session.mcap
await-files
await-line session.mcap was shown before: Y offers it beside this
press Y
frame 4
press enter
frame 4
await-files
parting largest
await-line the two are nowhere apart
drop $demo/session.mcap
drop $demo/session.mcap accepted%20session.mcap
await-files
parting largest
await-line the two are nowhere apart
quit
SCRIPT
look
