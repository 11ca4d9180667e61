# Events, lists, files of times and steps: which frames there are, and how their files are called.
log=$SRC/examples/demo/session.mcap
cell=$SRC/examples/demo/demo.cell.toml
small="--size 32x24 --samples 1 --shading plain"
rocinante-render $cell $log $small --events --frames events --sheet events.png
find events | sort
rocinante-render $cell $log $small --event 'pla*' --camera map --camera fit --frames two -o one.png
find two | sort; ls one*
printf '# two of them\n 1.5s\n\n-1s # near the end\n' > times.txt
rocinante-render $cell $log $small --at 3 --at-file times.txt --hash | cut -d' ' -f1
rocinante-render $cell $log $small --every 2s --from 3s --until 8s --json | grep -o '"time": "[^"]*"'
# A time of a list is the same picture as alone, whatever stands before it.
many=$(rocinante-render $cell $log $small --at 9 --at 2 --at 5 --hash | sed -n 's/^5 //p')
test "$many" = "$(rocinante-render $cell $log $small --at 5 --hash)"
try() { rocinante-render $cell $log $small "$@" 2>&1 && echo "exit 0" || echo "exit $?"; }
try --events --at 3 --hash
try --event nothing --hash | sed "s:$SRC/::"
try --at 3 --from 2s --hash
try --from 8s --until 3s --every 1s --hash
printf '1\nsoon\n' > bad.txt
try --at-file bad.txt --hash
try --at-file none.txt --hash
try --event 'p*' --camera map --camera map --frames same
