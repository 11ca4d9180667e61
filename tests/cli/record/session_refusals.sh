# What cannot be, or not together, is said before a socket is bound.
for options in '--split-size 100' '--split-size lots' '--split-time 0s' '--keep 0' '--disk-quota 1kB' \
  '--split-size 2MB --disk-quota 1MB' '--keep 3 --attach-once' '--ring-on boom' '--ring 30s --split-time 1m' '--ring 0s' \
  '--ring 30s --ring-size 1MB' '--ring 30s --ring-on packets=5' '--start-on silence=2s' '--stop-on silence=soon' \
  '--start-on event=' '--status 0s' '-o %n%q.mcap' '--ring 5s -o /nowhere/at/all.mcap' '--watch cell.toml' '--ring 5s --watch-severity note' \
  '--ring 5s --watch cell.toml --watch-severity loud'; do
  status=0
  # shellcheck disable=SC2086
  rocinante record 127.0.0.1:0 $options || status=$?
  echo "$options: $status"
done
ls
