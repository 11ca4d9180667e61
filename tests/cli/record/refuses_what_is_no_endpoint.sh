for endpoint in 127.0.0.1 127.0.0.1:99999 ::1:5 'nats://localhost:4222/arm' '239.1.2.3:5?speed=3' \
  '1.2.3.4:5?interface=lo' '239.1.2.3:0?interface=nowhere0'; do
  status=0
  rocinante record "$endpoint" -o log.mcap || status=$?
  echo "$status"
done
ls
