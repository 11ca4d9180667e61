printf 'not a log' >no.mcap
for log in missing.mcap no.mcap; do
  rocinante play $log --to 127.0.0.1:9 || echo "exit $?"
done
