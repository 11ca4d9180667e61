# Shift+G adds the moment that is shown to the suite beside it. A suite of another session is refused: its cases would
# be drawn of that one, not of what was seen.
export ASAN_OPTIONS=detect_leaks=0
cp -r "$SRC/examples/demo" demo && cd demo
rocinante log cut session.mcap -o other.mcap --from 1s --until 4s >/dev/null
look() {
  printf 'seek 2s\n%s\nquit\n' "$2" >script.txt
  with_display rocinante view demo.cell.toml "$1" --camera overview --size 160x120 --profile reproducible \
    --script script.txt 2>&1 || echo "exit $?"
}
look session.mcap 'golden-case first'
cp view.suite.toml before.toml
echo "another session:"
look other.mcap 'golden-case second'
cmp view.suite.toml before.toml
echo "another cell:"
cp demo.cell.toml other.cell.toml && echo '# as somebody changed it' >>other.cell.toml
sed -i 's/^cell = .*/cell = "other.cell.toml"/' view.suite.toml && cp view.suite.toml before.toml
look session.mcap 'golden-case second'
cmp view.suite.toml before.toml
echo "by the keys:"
look other.mcap 'key shift+G
frame 2'
cmp view.suite.toml before.toml
