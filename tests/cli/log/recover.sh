# What `log recover` makes, and of what it makes nothing.
. "$SRC/tests/support/blocks.sh"

# Nothing is missing where only the summary is; the end's reason is kept.
block "recover whole"
cp "$SRC/tests/data/logs/version-1.mcap" session.mcap
rocinante log recover session.mcap -o same.mcap
head -c $(($(stat -c %s session.mcap) - 100)) session.mcap > unclosed.mcap
rocinante log recover unclosed.mcap -o whole.mcap
for log in session.mcap same.mcap whole.mcap; do
  rocinante log info --json $log | grep -E '"(content_sha256|end_reason)"'
done
printf '?' | dd of=unclosed.mcap bs=1 seek=1 conv=notrunc status=none
rocinante log recover unclosed.mcap -o begun.mcap

# Recovers the readable part of a log that ends inside a chunk, and names the rest.
block "recover cut"
head -c 1200 "$SRC/tests/data/logs/version-1.mcap" > killed.mcap
status=0
rocinante log recover killed.mcap -o whole.mcap --json | sed '/"bytes"/d' || status=$?
rocinante log recover killed.mcap -o again.mcap || status=$?
echo "exit $status"
rocinante log doctor whole.mcap | cut -d'(' -f1

# Where nothing can be read nothing is made.
block "recover nothing"
echo 'not a log' > notes.txt
: > empty.mcap
head -c 40 "$SRC/tests/data/logs/version-1.mcap" > begun.mcap
for log in notes.txt empty.mcap begun.mcap nowhere.mcap .; do
  status=0
  rocinante log recover $log -o out.mcap || status=$?
  echo "exit $status"
done
ls
