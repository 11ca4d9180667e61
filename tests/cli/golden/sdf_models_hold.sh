# One picture for each core feature of SDF visuals, where libsdformat is.
grep -q '^  sdf *on ' <(rocinante --version --parts) || { echo "skipped: built without ROCINANTE_SDF"; exit 77; }
rocinante golden run "$SRC/tests/golden/models/sdf/sdf.suite.toml" | sed -E 's/^(same +[a-z-]+): .*/\1/'
