# A log that carries its cell is shown alone: the window draws what render draws of the cell on disk.
# Under LeakSanitizer: what the X11 driver keeps has no name any more when the process ends.
export ASAN_OPTIONS=detect_leaks=0
demo=$SRC/examples/demo
rocinante log attach "$demo/session.mcap" --cell "$demo/demo.cell.toml" -o session.mcap >/dev/null
printf 'panels off\nframe 2\nscreenshot window.png\nquit\n' >script.txt
mkdir folders
TMPDIR=$PWD/folders with_display rocinante view session.mcap --at 12.5s --size 320x240 \
  --profile reproducible --script script.txt 2>/dev/null
ls folders
rocinante render "$demo/demo.cell.toml" "$demo/session.mcap" --at 12.5s --size 320x240 -o render.png
rocinante golden compare window.png render.png
