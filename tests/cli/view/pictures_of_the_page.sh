# The pictures of docs/programs/view.md are made by a script: here that it runs, not that they have the same bits.
export ASAN_OPTIONS=detect_leaks=0
ROCINANTE_BIN=$(dirname "$(command -v rocinante-view)") "$SRC/scripts/view_pictures" pictures | sed 's#.*/pictures/##'
for picture in pictures/*.png; do
  rocinante golden compare "$picture" "$SRC/docs/programs/${picture##*/}" --quiet >/dev/null || [ $? = 1 ] || echo "exit $?"
done
grep -o 'view-[a-z]*\.png' "$SRC/docs/programs/view.md" | sort -u
