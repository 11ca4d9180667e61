# The window itself, panels and all, driven by a script, judged by the pictures accepted in tests/cli/view/window. Their
# names are their keys: Dear ImGui's version, whose panels differ from release to release, then the renderer. Within a key
# pixels are equal; across renderers they are within rounding. ROCINANTE_UPDATE=1 keeps this machine's: look at it.
export ASAN_OPTIONS=detect_leaks=0
demo=$SRC/examples/demo
imgui=imgui$(rocinante --version --parts | sed -n 's/.* imgui \([0-9]*\.[0-9]*\).*/\1/p')
key=$imgui-$(rocinante render "$demo/demo.cell.toml" --size 32x24 --hash --json | sed -n 's/^ *"renderer": "\(.*\)",$/\1/p')
with_display rocinante view "$demo/demo.cell.toml" "$demo/session.mcap" --size 960x600 \
  --profile reproducible --script "$SRC/tests/cli/view/window.script"
golden=$SRC/tests/cli/view/window/$key.png
tier=exact
[ -z "${ROCINANTE_UPDATE:-}" ] || cp window.png "$golden"
if [ ! -e "$golden" ]; then
  golden=$(compgen -G "$SRC/tests/cli/view/window/$imgui-*.png" | sed -n 1p) ||
    { echo "skipped: no picture of $imgui is accepted"; exit 77; }
  tier=rounding
fi
rocinante golden compare window.png "$golden" --tier $tier --quiet | sed 's/^same:.*/same/'
