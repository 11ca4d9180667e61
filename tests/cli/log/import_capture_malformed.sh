# A datagram of a capture that begins as packet text and is none is kept, counted and named.
make_pcap some.pcap '0:whole:RK1 me@a 0 0\njoints arm 0' '10:whole:RK1 me@a x 0\njoints arm 1' '20:whole:RK1' '30:whole:RK2 not ours'
rocinante log import some.pcap -o some.mcap || echo "exit $?"
rocinante log import some.pcap -o again.mcap --json 2>/dev/null | grep -E '"(malformed|fault)"' || true
make_pcap good.pcap '0:whole:RK1 me@a 0 0\njoints arm 0'
rocinante log import good.pcap -o good.mcap --json | grep '"malformed"'
