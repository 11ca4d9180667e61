for option in --duration=0s --duration=soon --sync=-1s --compression=lz4 --compression=zstd:99 --output=%T.mcap; do
  status=0
  rocinante record 127.0.0.1:0 "$option" || status=$?
  echo "$status"
done
ls
