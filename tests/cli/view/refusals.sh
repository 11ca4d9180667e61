# Without a display, a sentence that says what draws without one; faults of a script by line.
unset DISPLAY WAYLAND_DISPLAY
cat >box.urdf <<'URDF'
<robot name="box"><link name="body"><visual><geometry><box size="1 1 1"/></geometry></visual></link></robot>
URDF
try() { rocinante view "$@" 2>&1 | sed 's/window on: .* (rocinante/window on: WHY (rocinante/' && echo "exit 0" || echo "exit $?"; }
try box.urdf
echo 'dance' >script.txt
try box.urdf --script script.txt
echo '# nothing' >script.txt
try box.urdf --script script.txt
try box.urdf --size 10
try box.urdf --at 3
try box.urdf session.mcap --live 127.0.0.1:0
try box.urdf --live --live 127.0.0.1:0 --live nonsense
try missing.urdf
# Recorded input that no window ever had.
printf 'mouse 10 10\nframe-at 2s\nframe-at 1s\n' >script.txt
try box.urdf --script script.txt
printf 'frame-at 1e99s\n' >script.txt
try box.urdf --script script.txt
try box.urdf --script script.txt --record-input again.txt
try box.urdf --record-input /nowhere/input.txt
