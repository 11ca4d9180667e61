# A level that was asked for is a picture like any other: the same bits whatever the threads, its own
# at every level, and what the window draws on it.
export ASAN_OPTIONS=detect_leaks=0
demo=$SRC/examples/demo
render() { rocinante render "$demo/demo.cell.toml" "$demo/session.mcap" --at 12.5s --size 320x240 "$@"; }
LP_NUM_THREADS=0 render --detail 8 --hash >one.txt
LP_NUM_THREADS=3 render --detail 8 --hash >two.txt
cmp one.txt two.txt && echo "level 8: the same bits"
render --hash >plain.txt
render --detail 0 --hash | cmp - plain.txt && echo "level 0: everything"
cmp -s one.txt plain.txt || echo "level 8: less"
render --detail 8 -o render.png
printf 'panels off\nframe 2\nscreenshot window.png\nquit\n' >script.txt
with_display rocinante view "$demo/demo.cell.toml" "$demo/session.mcap" \
  --at 12.5s --size 320x240 --profile reproducible --detail 8 --script script.txt
cmp window.png render.png && echo "level 8: as in the window"
render --detail 10 --hash
