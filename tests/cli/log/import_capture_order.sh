# Times of a capture that are out of order are raised, and counted; by record, too.
make_pcap order.pcap '0:whole:a' '30:whole:b' '25:whole:c' '12:whole:d' '31:whole:e'
rocinante log import order.pcap -o order.mcap 2>&1 >/dev/null
rocinante record pcap://./order.pcap -o recorded.mcap 2>&1 | grep raised
rocinante log info order.mcap | grep -o '[0-9]* times.*raised to it'
