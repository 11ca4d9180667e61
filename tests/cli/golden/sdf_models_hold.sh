# One picture for each core feature of SDF visuals, where libsdformat is.
rocinante --version --parts | grep -q '^  sdf *on ' || { echo "skipped: built without ROCINANTE_SDF"; exit 77; }
rocinante golden run "$SRC/tests/golden/models/sdf/sdf.suite.toml" | sed -E 's/^(same +[a-z-]+): .*/\1/'
