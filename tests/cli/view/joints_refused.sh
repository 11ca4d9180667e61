# What cannot be moved by hand is said before a window opens.
unset DISPLAY WAYLAND_DISPLAY
demo=$SRC/examples/demo
try() { rocinante view "$@" 2>&1 | sed 's/^For more information.*//; /^$/d' && echo "exit 0" || echo "exit $?"; }
try "$demo/demo.cell.toml" "$demo/session.mcap" --joints arm=0
try "$demo/demo.cell.toml" --joints 0
try "$demo/demo.cell.toml" --joints arm=0,0
try "$demo/demo.cell.toml" --drive nowhere
try "$demo/demo.cell.toml" --as me
