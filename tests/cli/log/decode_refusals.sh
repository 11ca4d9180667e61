# A declaration's fault has its place; a log of which nothing is decoded is a no.
cp "$SRC/tests/data/logs/version-1.mcap" session.mcap
printf '[[decoder]]\nname = "arm"\nkind = "struct"\n[[decoder.field]]\nname = "q"\nat = 0\ntype = "f32"\n[[decoder.joint]]\ndevice = "arm"\njoint = "j"\nfield = "p"\n' >arm.decoders.toml
rocinante log decode session.mcap --decoders arm.decoders.toml -o out.mcap || echo $?
rocinante log decode session.mcap --decoders none.toml -o out.mcap || echo $?
sed -i 's/"p"/"q"/; s/kind/bytes = 77777\nkind/' arm.decoders.toml
rocinante log decode session.mcap --decoders arm.decoders.toml -o out.mcap || echo $?
rocinante log decode session.mcap --decoders arm.decoders.toml -o session.mcap || echo $?
