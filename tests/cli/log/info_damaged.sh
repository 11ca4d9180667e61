# A changed byte is found by the chunk's checksum, and named.
cp "$SRC/tests/data/logs/version-1.mcap" damaged.mcap
printf 'X' | dd of=damaged.mcap bs=1 seek=600 conv=notrunc status=none
rocinante log info --json damaged.mcap | sed -n '/"damage"/,$p' || echo "exit $?"
status=0; rocinante log info damaged.mcap > text || status=$?
echo "exit $status"
