# One picture for each core feature of URDF: equal pixels, or on another Mesa within rounding.
rocinante golden run "$SRC/tests/golden/models/urdf/urdf.suite.toml" | sed -E 's/^(same +[a-z-]+): .*/\1/'
