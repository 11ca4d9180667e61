# A stop signal ends an import soon, and nothing half made stays. The table is so long that it is never hashed.
printf '<robot name="arm"><link name="base"/></robot>' >arm.urdf
printf 't,arm.a\n0,1\n' >long.csv
truncate -s 64G long.csv
stopped() {
  "$@" >/dev/null 2>said &
  local program=$!
  # Until it catches SIGTERM: bit 14 of what it catches.
  until (($((16#$(sed -n 's/^SigCgt:\t*//p' /proc/$program/status))) & 16384)); do :; done
  kill -TERM $program
  wait $program || echo "exit $?"
  sed 's/stopped.*/stopped/' said
}
stopped rocinante-check arm.urdf long.csv
stopped rocinante-render arm.urdf long.csv --hash
stopped rocinante-play long.csv --to udp://127.0.0.1:9
ls -A "$XDG_CACHE_HOME"/rocinante/imports 2>/dev/null || true
