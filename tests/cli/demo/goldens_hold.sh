# The committed session of the demo, judged against the committed goldens: equal pixels.
rocinante golden run "$SRC/examples/demo/demo.suite.toml"
