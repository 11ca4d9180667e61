# What chooses nothing makes nothing.
cp "$SRC/tests/data/logs/version-1.mcap" session.mcap
for range in '--from 5s' '--from 0.5s --until 0.2s' '--from-event no-such' '--from soon' ''; do
  status=0
  rocinante log cut session.mcap -o out.mcap $range || status=$?
  echo "exit $status"
done
ls
