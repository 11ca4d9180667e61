# What cannot be judged exits 2, with one line on stderr.
rocinante check gone.cell.toml || echo "exit $?"
printf '<robot name="arm"><link name="base"/></robot>' >arm.urdf
rocinante check arm.urdf gone.mcap || echo "exit $?"
printf 'this is no log' >no.mcap
rocinante check arm.urdf no.mcap || echo "exit $?"
rocinante check arm.urdf --format yaml 2>/dev/null || echo "exit $?"
rocinante check arm.urdf --live 127.0.0.1:0 --duration 0s || echo "exit $?"
