# The window says while a moment is shown that damage may have left it older, and the exit code does afterwards; an evidence picture is
# made all the same.
export ASAN_OPTIONS=detect_leaks=0
python3 "$SRC/tests/cli/spoil_chunks" "$SRC/examples/demo/session.mcap" half.mcap 10 99
cat >look <<'SH'
rocinante view "$SRC/examples/demo/demo.cell.toml" half.mcap --size 320x240 --profile reproducible --script script.txt 2>said
echo "exit $?" >code
SH
look() {
  rm -f code
  with_display bash look 2>/dev/null || true
  sed 's/checksum ([0-9a-f]*, stored [0-9a-f]*)/checksum/' said
  cat code
}
printf 'seek 5s\nframe 2\nquit\n' >script.txt
look
printf 'panels off\nseek 15.25s\nframe 2\nscreenshot window.png\nevidence evidence.png\nquit\n' >script.txt
look
ls evidence.png
