try() {
  status=0
  rocinante spy "$@" || status=$?
  echo "$status"
}
try 127.0.0.1:0 --allow 10.0.0.5/8
try 127.0.0.1:0 --allow robot7
try 127.0.0.1:0 --duration 0s
try 'pcap://eth0?ttl=1'
try pcap://./none.pcap
printf 'no capture at all, but long enough' >text.pcap
try pcap://./text.pcap
try pcap://./text.pcap 127.0.0.1:0
