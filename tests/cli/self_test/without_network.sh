# A network of its own whose loopback interface is down, as in a strict sandbox: said, with what to do.
spaces=-rn
[ "$(id -u)" != 0 ] || spaces=-n
unshare $spaces true 2>/dev/null || { echo "skipped: no network namespaces for this user"; exit 77; }
unshare $spaces "$(command -v rocinante)" --self-test --only multicast,ipv6,receive_buffer >facts || echo "exit $?"
cut -c1-24 facts | grep -v 'receive_buffer\| ok,'
grep -o 'sudo ip link set lo up' facts
