# An unreadable log is not reported as empty: the damage is named.
cp "$SRC/tests/data/logs/version-1.mcap" session.mcap
rocinante log cut session.mcap -o holed.mcap --from 0 >/dev/null
printf 'XXXXXXXX' | dd of=holed.mcap bs=1 seek=320 conv=notrunc status=none
{
  rocinante play holed.mcap --asap --to 127.0.0.1:9 || echo "exit $?"
  rocinante log cut holed.mcap -o out.mcap --from 0 || echo "exit $?"
} 2>&1 | sed -e 's/byte[s]* [0-9]*/byte N/' -e 's/\(the chunk\) .*/\1 .../'
ls
