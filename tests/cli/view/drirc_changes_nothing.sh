# Options of the driver that are set in the home folder change no pixel of the window.
export ASAN_OPTIONS=detect_leaks=0
cat >script.txt <<'SCRIPT'
camera overview
seek 5s
frame 2
screenshot window.png
quit
SCRIPT
mkdir plain set
window() {
  (cd "$1" && with_display env HOME="$PWD" rocinante view \
    "$SRC/examples/demo/demo.cell.toml" "$SRC/examples/demo/session.mcap" --size 480x300 \
    --profile reproducible --script ../script.txt 2>stderr)
}
{
  echo '<driconf><device><application name="all">'
  for option in force_integer_tex_nearest force_glsl_abs_sqrt glsl_zero_init pp_noblue \
    vs_position_always_precise vs_position_always_invariant glsl_correct_derivatives_after_discard \
    allow_draw_out_of_order disable_glsl_line_continuations dual_color_blend_by_location; do
    echo "<option name=\"$option\" value=\"true\"/>"
  done
  echo '<option name="pp_celshade" value="1"/><option name="pp_jimenezmlaa" value="8"/>'
  echo '</application></device></driconf>'
} >set/.drirc
window plain
window set
rocinante golden compare plain/window.png set/window.png
