# Without any right: less exact, and each line names the command that gives the right back. Root keeps its name here and
# loses its capabilities.
without=(env)
if [ "$(id -u)" = 0 ]; then
  command -v setpriv >/dev/null || { echo "skipped: no setpriv"; exit 77; }
  without=(setpriv --inh-caps=-all --bounding-set=-all)
fi
[ "$(ulimit -r)" = 0 ] || { echo "skipped: this user may have real-time scheduling"; exit 77; }
"${without[@]}" rocinante --self-test --only scheduling,priority,capture >facts || echo "exit $?"
sed "s|$(dirname "$(readlink -f "$(command -v rocinante)")")|BIN|g" facts
# The buffer is what net.core.rmem_max allows, or all that is asked for.
most=$(cat /proc/sys/net/core/rmem_max)
"${without[@]}" rocinante --self-test --only receive_buffer >buffer || true
if [ "$most" -ge 33554432 ]; then grep -q '^ok' buffer; else grep -q '^limited.*rmem_max=33554432' buffer; fi
