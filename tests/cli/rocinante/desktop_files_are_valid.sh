# The desktop entry, the types of our files and the icon, judged by the tools that read them.
for tool in desktop-file-validate update-mime-database; do
  command -v $tool >/dev/null || { echo "skipped: there is no $tool here"; exit 77; }
done
desktop-file-validate "$SRC/desktop/rocinante-view.desktop"
mkdir -p mime/packages
cp "$SRC/desktop/rocinante.xml" mime/packages
XDG_DATA_HOME=$PWD PKGSYSTEM_ENABLE_FSYNC=0 update-mime-database "$PWD/mime"
grep -v '^#' mime/globs2
python3 -c 'import sys, xml.dom.minidom as dom; print(dom.parse(sys.argv[1]).documentElement.tagName)' "$SRC/desktop/rocinante.svg"
# Every type that the entry opens is declared.
for type in $(sed -n 's/^MimeType=//p' "$SRC/desktop/rocinante-view.desktop" | tr ';' ' '); do
  grep -q "type=\"$type\"" "$SRC/desktop/rocinante.xml" || echo "$type is opened and not described"
done
