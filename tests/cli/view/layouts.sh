# A layout is written, shown again by option and by command, and lists what is missing in the cell; other files stay as they are.
export ASAN_OPTIONS=detect_leaks=0
cp "$SRC/examples/demo/session.mcap" session.mcap
demo=$SRC/examples/demo/demo.cell.toml
show() {
  with_display rocinante view "$demo" session.mcap --size 640x400 --samples 1 --profile reproducible --script "$@"
}
printf '%s\n' 'plot arm.joint2' 'camera overview' 'fold left on' 'theme light' 'frame 2' 'save-layout forces' \
  'screenshot before.png' >save.txt
show save.txt
cat forces.layout.toml
printf '%s\n' 'frame 2' 'screenshot after.png' >look.txt
show look.txt --layout forces.layout.toml
rocinante golden compare before.png after.png
# A camera that every cell has is fitted anew.
printf '%s\n' 'panels off' 'camera map' 'frame 2' 'save-layout map' 'screenshot map.png' >map.txt
show map.txt
grep camera map.layout.toml
printf '%s\n' 'panels off' 'frame 2' 'screenshot again.png' >again.txt
show again.txt --layout map.layout.toml
rocinante golden compare map.png again.png
sed -i 's/arm.joint2/leg.joint2/' forces.layout.toml
printf '%s\n' 'layout forces.layout.toml' 'frame 2' 'await-line forces.layout.toml: no device is named `leg`' >other.txt
show other.txt && echo "said over the picture"
printf '%s\n' 'format = 1' 'plots = ["signal arm nothing"]' >signals.layout.toml
printf '%s\n' 'layout signals.layout.toml' 'frame 2' \
  'await-line no packet of the log states `signal arm nothing`, so its plot is empty' >signals.txt
show signals.txt && echo "said over the picture"
printf '%s\n' "save-layout session.mcap" >bad.txt
cp session.mcap session.mcap.layout.toml
show bad.txt || echo "exit $?"
cmp session.mcap session.mcap.layout.toml && echo "still there"
show look.txt --layout session.mcap || echo "exit $?"
show look.txt --layout none.layout.toml || echo "exit $?"
