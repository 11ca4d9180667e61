# The target `programs`, which scripts/demo builds, has all that `cmake --install` takes: every program's
# man pages are made with it.
build=$(dirname "$(dirname "$(command -v rocinante)")")
[ -e "$build/build.ninja" ] || { echo "skipped: not built by ninja"; exit 77; }
grep -q '^ROCINANTE_HELP2MAN:.*NOTFOUND' "$build/CMakeCache.txt" && { echo "skipped: no help2man"; exit 77; }
grep '^build programs: phony ' "$build/build.ninja" | tr ' ' '\n' >inputs
sed -nE 's#^bin/(rocinante.*)$#\1#p' inputs | sort -u >programs
sed -nE 's#^.*/(rocinante.*)_man_pages$#\1#p' inputs | sort -u >with_pages
comm -23 programs with_pages
[ "$(wc -l <programs)" -ge 10 ] && echo "every program"
