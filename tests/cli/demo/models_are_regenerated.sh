# The committed models are what the script writes, byte for byte.
python3 "$SRC/examples/demo/make_models.py" "$PWD/made"
(cd made && find . -type f | LC_ALL=C sort) | while read -r file; do
  cmp "$SRC/examples/demo/$file" "made/$file" && echo "same $file"
done
