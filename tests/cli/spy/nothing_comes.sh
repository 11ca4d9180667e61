# Nothing judged is never yes: exit 2, and the reason why.
rocinante spy 127.0.0.1:0 --duration 2.2s --json 2>/dev/null | sed 's/:[0-9]*"/:PORT"/; s/"watched_s": .*,/"watched_s": 2.2,/; s/127.0.0.1:[0-9]* for [0-9]* s/127.0.0.1:PORT for 2 s/'
