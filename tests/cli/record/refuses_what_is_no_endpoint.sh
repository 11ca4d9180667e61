for endpoint in 127.0.0.1 127.0.0.1:99999 ::1:5 'nats://localhost:4222' '239.1.2.3:5?speed=3' \
  '1.2.3.4:5?interface=lo' '239.1.2.3:0?interface=nowhere0'; do
  status=0
  rocinante record "$endpoint" -o log.mcap 2>said || status=$?
  # Every machine has other interfaces.
  sed 's/; there are .* (/; there are ... (/' said >&2
  rm said
  echo "$status"
done
ls
