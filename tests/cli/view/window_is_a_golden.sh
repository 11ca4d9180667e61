# The window itself, panels and all, driven by a script: the same pixels as the accepted screenshot,
# tests/cli/view/window.png (renderer llvmpipe of Mesa 22.3.6; another Mesa wants another picture).
export ASAN_OPTIONS=detect_leaks=0
xvfb-run -a -s '-screen 0 1280x1024x24' rocinante view "$SRC/examples/demo/demo.cell.toml" \
  "$SRC/examples/demo/session.mcap" --size 960x600 --profile reproducible --script "$SRC/tests/cli/view/window.script"
rocinante golden compare window.png "$SRC/tests/cli/view/window.png"
