# The models of tests/golden/models/collada are what their script writes, byte for byte; their
# pictures are those that were accepted: equal pixels, or on another Mesa within rounding.
models="$SRC/tests/golden/models/collada"
python3 "$models/make_models.py" "$PWD/made"
for file in made/*; do cmp "$models/$(basename "$file")" "$file" && echo "same $(basename "$file")"; done
cd "$models"
rocinante golden run collada.suite.toml | sed -E 's/^(same +[a-z-]+): .*/\1/'
