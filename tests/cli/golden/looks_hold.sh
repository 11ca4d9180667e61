# Frames with looks, of the demo's data, judged against the committed goldens: equal pixels.
rocinante golden run "$SRC/tests/golden/looks/looks.suite.toml"
