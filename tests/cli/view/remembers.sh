# The window remembers its size and recent files; --fresh neither reads nor writes that. What
# cannot be read stays as it is, and what cannot be written is named.
command -v xdotool >/dev/null || { echo "skipped: no xdotool"; exit 77; }
export ASAN_OPTIONS=detect_leaks=0
cat >box.urdf <<'URDF'
<robot name="box"><link name="body"><visual><geometry><box size="1 1 1"/></geometry></visual></link></robot>
URDF
cat >person.sh <<'PERSON'
view() {
  rocinante view box.urdf --detail 0 --samples 1 "$@" 2>view.txt &
  viewer=$!
  window=$(xdotool search --sync --onlyvisible --name '^Rocinante')
}
quit() {
  xdotool key --window 0 q
  wait $viewer
  echo "view: exit $?"
}
memory=$XDG_CONFIG_HOME/rocinante/view.toml
view --size 700x500
quit
sed "s|$PWD|HERE|" "$memory"
cp "$memory" before.toml
view --fresh --size 300x200
quit
cmp "$memory" before.toml && echo "fresh: nothing changed"
echo 'theme = "pink"' >"$memory"
view
quit
sed "s|$PWD|HERE|; s|$XDG_CONFIG_HOME|CONFIG|" view.txt
cat "$memory"
export XDG_CONFIG_HOME=$PWD/box.urdf
view
quit
sed "s|$PWD|HERE|" view.txt
PERSON
with_display bash person.sh
