# Every program and every subcommand has a page, made from its --help, that names it and that the page
# formatter takes without a word.
for tool in help2man man lexgrog; do
  command -v $tool >/dev/null || { echo "skipped: there is no $tool here"; exit 77; }
done
bin=$(dirname "$(command -v rocinante)")
verbs=$(rocinante --help | sed -n 's/^  \([a-z]*\) .*/\1/p')
pages="rocinante"
"$SRC/cmake/make_man_pages" "$bin" rocinante pages 1.2.3 /usr
for verb in $verbs; do
  [ -x "$bin/rocinante-$verb" ] || continue
  "$SRC/cmake/make_man_pages" "$bin" "rocinante-$verb" pages 1.2.3 /usr
  pages="$pages rocinante-$verb"
  for sub in $(rocinante "$verb" --help | sed -n '/^Subcommands:/,/^$/s/^  \([a-z-]*\) .*/\1/p'); do
    pages="$pages rocinante-$verb-$sub"
  done
done
# No verb, but a program that may be run by hand.
if [ -x "$bin/rocinante-self-test-draw" ]; then
  "$SRC/cmake/make_man_pages" "$bin" rocinante-self-test-draw pages 1.2.3 /usr
  pages="$pages rocinante-self-test-draw"
fi
for page in $pages; do
  LC_ALL=C.UTF-8 man -E UTF-8 --warnings -l "pages/$page.1.gz" 2>&1 >/dev/null
  grep -q "\"$page - [A-Za-z]" <(lexgrog "pages/$page.1.gz") || echo "$page has no name line"
  zcat "pages/$page.1.gz" >page
  for section in "EXIT STATUS" FILES "SEE ALSO"; do
    grep -qx ".SH \"\?$section\"\?" page || echo "$page says nothing of $section"
  done
  ! command -v mandoc >/dev/null || mandoc -Tlint -Wwarning page
done
[ "$(find pages -type f | wc -l)" = "$(wc -w <<<"$pages")" ] || ls pages
# A page whose subcommand is gone goes too.
touch pages/rocinante-log-gone.1.gz
"$SRC/cmake/make_man_pages" "$bin" rocinante-log pages 1.2.3 /usr
[ ! -e pages/rocinante-log-gone.1.gz ]
zcat pages/rocinante-log-shift.1.gz | SOURCE_DATE_EPOCH=0 man -l - | grep -A 1 -E '^(NAME|SYNOPSIS|SEE ALSO)' | sed 's/  */ /g'
