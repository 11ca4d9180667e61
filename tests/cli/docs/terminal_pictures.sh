# The pictures of terminals in docs/programs are what the programs write today. How many pixels differ is
# the renderer's, and how large a log is that of its compressor.
ROCINANTE_BIN=$(dirname "$(command -v rocinante)") "$SRC/scripts/terminal_pictures" here | sed 's#.*/##'
for picture in here/*.svg; do
  same() { sed -E 's/[0-9]+ differing/N differing/; s/[0-9.]+ .B\)/SIZE)/; s/ textLength="[0-9]+"//' "$1"; }
  cmp <(same "$picture") <(same "$SRC/docs/programs/${picture##*/}")
  grep -qF "(${picture##*/})" "$SRC"/docs/programs/*.md || echo "no page shows ${picture##*/}"
done
