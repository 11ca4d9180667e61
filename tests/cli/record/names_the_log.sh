# A folder takes the default name, a pattern is filled in.
mkdir logs
rocinante record 127.0.0.1:0 -o logs --duration 0.02s --quiet
ls logs | sed 's/[0-9]/9/g'
rocinante record 127.0.0.1:0 -o 'cell-%F.mcap' --duration 0.02s --quiet
ls cell-* | sed 's/[0-9]/9/g'
rocinante record 127.0.0.1:0 --duration 0.02s 2>/dev/null | sed -e 's/[0-9]/9/g' -e 's/9* B/9 B/' -e 's/:9* (/:PORT (/'
