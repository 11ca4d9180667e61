# The models of tests/golden/models/obj are what their script writes, byte for byte; their pictures
# are those that were accepted: equal pixels, or on another Mesa within rounding.
models="$SRC/tests/golden/models/obj"
python3 "$models/make_models.py" "$PWD/made"
(cd made && find . -type f | LC_ALL=C sort) | sed 's|^\./||' | while read -r file; do
  cmp "$models/$file" "made/$file" && echo "same $file"
done
rocinante golden run "$models/obj.suite.toml" | sed -E 's/^(same +[a-z-]+): .*/\1/'
