# A file of another known kind is refused by the name of its kind.
try() { rocinante log "$@" || echo "exit $?"; }
exec 2>&1
printf '\xd4\xc3\xb2\xa1\x02\x00\x04\x00' >cell.pcap
printf '\x0a\x0d\x0d\x0a\x1c\x00\x00\x00' >cell.pcapng
gzip -c "$SRC/tests/data/logs/version-1.mcap" >session.mcap.gz
printf '#ROSBAG V2.0\n' >session.bag
printf 'SQLite format 3\0' >session.db3
for file in cell.pcap cell.pcapng session.mcap.gz session.bag session.db3; do try info "$file"; done
try doctor cell.pcap
rocinante record cell.pcap || echo "exit $?"
