# The committed session of the demo, judged against the committed goldens: equal pixels, or on another
# Mesa within rounding.
rocinante golden run "$SRC/examples/demo/demo.suite.toml" | sed -E 's/^(same +[a-z-]+): .*/\1/'
