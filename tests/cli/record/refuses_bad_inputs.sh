try() {
  status=0
  rocinante record "$@" -o log.mcap || status=$?
  echo "$status"
}
try 127.0.0.1:0 --allow 10.0.0.5/8
try 127.0.0.1:0 --tee nonsense
try 127.0.0.1:0 --tee :5000
try 127.0.0.1:0 --tee pcap://lo
try pcap://./none.pcap
printf 'no capture at all, but long enough' >text.pcap
try pcap://./text.pcap
try pcap://./text.pcap 127.0.0.1:0
ls
