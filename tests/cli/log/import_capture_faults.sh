# What a capture's import counts: what is malformed, and times out of order.
. "$SRC/tests/support/blocks.sh"

# A datagram of a capture that begins as packet text and is none is kept, counted and named.
block "import capture malformed"
make_pcap some.pcap '0:whole:RK1 me@a 0 0\njoints arm 0' '10:whole:RK1 me@a x 0\njoints arm 1' '20:whole:RK1' '30:whole:RK2 not ours'
rocinante log import some.pcap -o some.mcap || echo "exit $?"
rocinante log import some.pcap -o again.mcap --json 2>/dev/null | grep -E '"(malformed|fault)"' || true
make_pcap good.pcap '0:whole:RK1 me@a 0 0\njoints arm 0'
rocinante log import good.pcap -o good.mcap --json | grep '"malformed"'

# Times of a capture that are out of order are raised, and counted; by record, too.
block "import capture order"
make_pcap order.pcap '0:whole:a' '30:whole:b' '25:whole:c' '12:whole:d' '31:whole:e'
rocinante log import order.pcap -o order.mcap 2>&1 >/dev/null
rocinante record pcap://./order.pcap -o recorded.mcap 2>&1 | grep raised
rocinante log info order.mcap | grep -o '[0-9]* times.*raised to it'
