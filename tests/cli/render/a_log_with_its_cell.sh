# A log that carries its cell draws the same bits as the cell on disk, in render, and fits in check and golden.
demo=$SRC/examples/demo
rocinante log attach "$demo/session.mcap" --cell "$demo/demo.cell.toml" -o session.mcap
at_disk=$(rocinante render "$demo/demo.cell.toml" "$demo/session.mcap" --at 3 --at 12.5 --hash --size 160x120)
test "$at_disk" = "$(TMPDIR=$PWD rocinante render session.mcap --at 3 --at 12.5 --hash --size 160x120)" && echo "the same pictures"
# One on disk wins over the one inside.
printf '<robot name="arm"><link name="base"/></robot>' >arm.urdf
given=$(rocinante render arm.urdf session.mcap --at 3 --at 12.5 --hash --size 160x120)
test "$at_disk" != "$given" && echo "the given cell"
test "$at_disk" = "$(rocinante render session.mcap "$demo/session.mcap" --at 3 --at 12.5 --hash --size 160x120)" && echo "another log"
rocinante check session.mcap | tail -n 1
sed '/^cell = /d' "$demo/demo.suite.toml" >suite.toml
cp -r "$demo/goldens" goldens
rocinante golden run suite.toml | tail -n 1
rocinante render "$demo/session.mcap" --at 3 --hash 2>&1 | sed "s|$SRC/||" || echo "exit $?"
rocinante render session.mcap --search . --at 3 --hash || echo "exit $?"
ls
