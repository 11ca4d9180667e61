# Nothing is missing where only the summary is; the end's reason is kept.
cp "$SRC/tests/data/logs/version-1.mcap" session.mcap
rocinante log recover session.mcap -o same.mcap
head -c $(($(stat -c %s session.mcap) - 100)) session.mcap > unclosed.mcap
rocinante log recover unclosed.mcap -o whole.mcap
for log in session.mcap same.mcap whole.mcap; do
  rocinante log info --json $log | grep -E '"(content_sha256|end_reason)"'
done
printf '?' | dd of=unclosed.mcap bs=1 seek=1 conv=notrunc status=none
rocinante log recover unclosed.mcap -o begun.mcap
