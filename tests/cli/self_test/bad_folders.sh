# A folder that cannot be written to, one that is gone, no home.
if [ "$(id -u)" = 0 ]; then
  command -v setpriv >/dev/null || { echo "skipped: no setpriv"; exit 77; }
  without=(setpriv --inh-caps=-all --bounding-set=-all)
fi
facts() { "${without[@]}" env "$@" --self-test --only files,cache | sed -E "s|$HERE|HERE|; s/, [0-9.]+ [kMGTP]?B free//"; }
HERE=$PWD
mkdir read-only home
touch home/.cache
chmod 555 read-only
cd read-only
facts HOME="$HERE/home" XDG_CACHE_HOME= rocinante || echo "exit $?"
ls -A
mkdir "$HERE/gone"
cd "$HERE/gone"
rmdir "$HERE/gone"
facts -u HOME -u XDG_CACHE_HOME rocinante || echo "exit $?"
cd "$HERE/home"
facts XDG_CACHE_HOME="$HERE/home" rocinante
ls -A
