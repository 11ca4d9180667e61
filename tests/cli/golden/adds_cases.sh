# A case is appended behind everything that stands there, and only when the suite stays sound.
cat >box.urdf <<'URDF'
<robot name="box"><link name="body"><visual><geometry><box size="1 1 1"/></geometry></visual></link></robot>
URDF
rocinante golden add new.toml --case front || echo "exit $?"
rocinante golden add new.toml --cell box.urdf --case front --size 64x48 --samples 1
printf '# a comment that stays\n[tolerance.lax]\ntile_mean = 9.0   # and this one' >>new.toml
cp new.toml before.toml
rocinante golden add new.toml --case side --camera map --layers labels,grid --layers points \
  --hide layer/grid --mask layer/labels --tolerance lax \
  --style edges=only --style shadows --tag slow --expect different --reason 'say "why"'
head -c "$(wc -c <before.toml)" new.toml | cmp - before.toml && echo "the old bytes are there"
tail -n +9 new.toml
cp new.toml before.toml
rocinante golden add new.toml --case side || echo "exit $?"
rocinante golden add new.toml --case other --samples 3 || echo "exit $?"
rocinante golden add new.toml --case ../up || echo "exit $?"
rocinante golden add new.toml --case other --style glow || echo "exit $?"
# Another session's case is refused; the same files, by any name, are the suite's.
sed 's/1 1 1/2 2 2/' box.urdf >large.urdf
rocinante golden add new.toml --case other --cell large.urdf || echo "exit $?"
rocinante golden add new.toml --case other --cell box.urdf --log "$SRC/examples/demo/session.mcap" || echo "exit $?"
cmp before.toml new.toml && ls
mkdir sub && cp box.urdf sub/copy.urdf
rocinante golden add new.toml --case other --cell sub/copy.urdf
cp "$SRC/examples/demo/session.mcap" "$SRC/examples/demo/motion.mcap" .
rocinante golden add logs.toml --cell box.urdf --log session.mcap --case first --at picked
rocinante golden add logs.toml --cell box.urdf --log session.mcap --case second --at 2s
rocinante golden add logs.toml --cell box.urdf --log motion.mcap --case third --at 2s || echo "exit $?"
rocinante golden add logs.toml --cell session.mcap --log session.mcap --case fourth --at 2s || echo "exit $?"
cat logs.toml
