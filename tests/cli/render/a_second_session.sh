# A second log as ghosts: nothing where both are equal, the devices that are elsewhere where they are not, at the moments
# that --align says. What cannot be aligned is one sentence.
demo=$SRC/examples/demo cell=$SRC/examples/demo/demo.cell.toml log=$SRC/examples/demo/session.mcap
cp $log today.mcap
# The same session from 2 s on.
rocinante log cut $log --from 2s -o accepted.mcap >/dev/null
draw() { rocinante render $cell today.mcap --camera overview --size 160x120 --hash "$@" 2>&1 || echo "exit $?"; }
alone=$(draw --at 7.5)
same() { if [ "$(draw --at 7.5 "$@")" = "$alone" ]; then echo "same: $*"; else echo "differs: $*"; fi; }
same --beside today.mcap
same --beside today.mcap --align events
same --beside accepted.mcap
same --beside accepted.mcap --align events
same --beside accepted.mcap --align=-2s
same --beside today.mcap --align 30s
same --beside accepted.mcap --align=-2s --hide beside:arm --hide beside:gantry --hide beside:canister
rocinante render $cell today.mcap --beside accepted.mcap --align=-2s --at 7.5 --camera overview --size 160x120 --identity ids.png
grep -o '"beside:[^"]*"' ids.json | sort -u
cp -r $demo/. . && cp demo.cell.toml cell.toml
rocinante render cell.toml today.mcap --beside accepted.mcap --align events --at 7.5 -o apart.png && ls apart.png
draw --at 7.5 --beside accepted.mcap --align middle
draw --at 7.5 --beside accepted.mcap --align event:never | sed "s:$SRC/::"
draw --at 7.5 --align events
draw --at 7.5 --beside gone.mcap
draw --at 7.5 --hide beside:arm
rocinante render $cell --beside accepted.mcap --hash 2>&1 || echo "exit $?"
