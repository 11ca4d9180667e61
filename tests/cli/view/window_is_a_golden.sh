# The window itself, panels and all, driven by a script: the same pixels as the accepted screenshot,
# tests/cli/view/window.png (renderer llvmpipe of Mesa 22.3.6; another Mesa wants another picture).
export ASAN_OPTIONS=detect_leaks=0
cat >script.txt <<'SCRIPT'
camera overview
seek 5s
speed 2
play
wait 0.5
pause
seek 7.88s
select gantry
orbit 60 -20
zoom 1
hide layer/labels
key E
click 712 330
style shadows on
detail 0
frame 2
screenshot window.png
quit
SCRIPT
xvfb-run -a -s '-screen 0 1280x1024x24' rocinante view "$SRC/examples/demo/demo.cell.toml" \
  "$SRC/examples/demo/session.mcap" --size 960x600 --profile reproducible --script script.txt
rocinante golden compare window.png "$SRC/tests/cli/view/window.png"
