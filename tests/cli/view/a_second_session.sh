# A second log beside the first: its ghosts are those of the evidence, which render draws; partings are gone to, the
# largest with a sentence; hidden, the picture is that of one session.
export ASAN_OPTIONS=detect_leaks=0
demo=$SRC/examples/demo
cp "$demo/session.mcap" accepted.mcap
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
screenshot hidden.png
evidence alone.png
panels on
beside on
plot arm.joint1
plot arm.joint2
seek 7.5s
frame 2
screenshot panels.png
quit
SCRIPT
look() { with_display rocinante view "$demo/demo.cell.toml" "$demo/session.mcap" --camera overview --size 640x480 \
  --profile reproducible --script script.txt "$@" 2>&1 || echo "exit $?"; }
look --beside accepted.mcap --align 1.5s
rocinante golden compare window.png evidence.png
rocinante golden compare hidden.png alone.png
rocinante golden compare window.png hidden.png --quiet | sed 's/:.*//' || echo "exit $?"
look --beside accepted.mcap --align nowhere
printf 'parting next\n' >script.txt
look
printf 'parting sideways\n' >script.txt
look
printf 'parting largest\nawait-line the largest difference:\nquit\n' >script.txt
look --beside accepted.mcap --align 1.5s
