# Frames with looks, of the demo's data, judged against the committed goldens: equal pixels, or on another
# Mesa within rounding.
rocinante golden run "$SRC/tests/golden/looks/looks.suite.toml" | sed -E 's/^(same +[a-z-]+): .*/\1/'
