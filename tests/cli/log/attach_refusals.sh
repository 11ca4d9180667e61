# Nothing is made if something would be lost, or if the arguments are ambiguous.
cp "$SRC/tests/data/logs/version-1.mcap" session.mcap
printf 'one\n' >notes.md
rocinante log attach session.mcap notes.md -o with.mcap
rocinante log attach with.mcap notes.md -o again.mcap || echo "exit $?"
printf 'two\n' >notes.md
rocinante log attach with.mcap notes.md -o again.mcap --replace
rocinante log extract again.mcap notes.md -o -
rocinante log attach session.mcap notes.md -o session.mcap --force || echo "exit $?"
rocinante log attach session.mcap notes.md -o with.mcap || echo "exit $?"
rocinante log attach session.mcap -o new.mcap || echo "exit $?"
rocinante log attach session.mcap gone.md -o new.mcap || echo "exit $?"
rocinante log attach session.mcap notes.md --name ../up -o new.mcap || echo "exit $?"
rocinante log attach session.mcap notes.md --name cell/a.urdf -o new.mcap || echo "exit $?"
rocinante log attach session.mcap notes.md with.mcap --name x -o new.mcap || echo "exit $?"
rocinante log attach session.mcap notes.md --search . -o new.mcap || echo "exit $?"
printf '<robot name="arm"><link name="base"/></robot>' >arm.urdf
rocinante log attach session.mcap --cell arm.urdf -o cell.mcap
rocinante log attach cell.mcap --cell arm.urdf -o new.mcap || echo "exit $?"
rocinante log attach cell.mcap --cell arm.urdf -o new.mcap --replace
rocinante log extract new.mcap --list | awk '{print $1, $4}'
ls
