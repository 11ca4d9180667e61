# A verb, a subcommand or an option that is nearly right is answered with the right one.
try() { "$@" || echo "exit $?"; }
exec 2>&1
try rocinante recrod
try rocinante log inf session.mcap
try rocinante log cut session.mcap --form 1s -o out.mcap
try rocinante record --durtion 1s
try rocinante play session.mcap --spe 2
try rocinante check session.mcap --cell cell.toml
try rocinante log state session.mcap --at
try rocinante log mark session.mcap 1s fell over
try rocinante log info session.mcap --nothing-like-it
rocinante help log cut | sed -n 2p
rocinante help spy | sed -n 1p
