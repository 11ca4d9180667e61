# A recording of nothing says so and exits with 0; --min-packets is the gate.
plain() { sed -e 's/\(127.0.0.1\|::1\]\):[0-9]*/\1:PORT/g' -e 's/([0-9.]* k*B)/(SIZE)/'; }
rocinante record 127.0.0.1:0 '[::1]:0' -o a.mcap --duration 50ms 2>/dev/null | sed 's/in [0-9.]* s/in T s/' | plain
rocinante record 127.0.0.1:0 -o b.mcap --duration 50ms --json 2>/dev/null | grep -E '"(packets|first_after_s|subscription)"' | sort -u
rocinante record 127.0.0.1:0 -o c.mcap --duration 50ms --quiet
rocinante record 127.0.0.1:0 -o d.mcap --duration 50ms --min-packets 1 2>&1 >/dev/null | grep -v '^recording' || echo "exit $?"
