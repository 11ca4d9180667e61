# What a build without OSMesa draws by, in place of OSMesa: every golden of this project passes unchanged, by equal
# pixels where they were drawn by this Mesa.
export ROCINANTE_CONTEXT=egl
for suite in examples/demo/demo tests/golden/looks/looks; do
  rocinante golden run "$SRC/$suite.suite.toml" | sed -E 's/^(same +[a-z-]+): .*/\1/'
done
