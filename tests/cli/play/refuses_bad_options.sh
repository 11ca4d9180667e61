printf 'not a log' >no.mcap
for options in "--speed 0" "--speed 2000" "--speed fast" "--to nowhere" "--asap --speed 2" \
  "--realtime maybe" "--loop -1"; do
  status=0
  # Each option and its value are words of their own.
  rocinante play no.mcap $options 2>said || status=$?
  tail -n 1 said
  echo "$status"
done
