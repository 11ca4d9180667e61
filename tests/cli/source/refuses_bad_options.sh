printf 't,a\n0,1\n' >table.csv
try() {
  status=0
  rocinante source "$@" --to 127.0.0.1:9 2>said || status=$?
  tail -n 1 said
  echo "$status"
}
try
try --csv table.csv
try --device arm
try --csv missing.csv --device arm
try --csv table.csv --device arm --speed 0.001
try --csv table.csv --device arm --restate soon
try --csv table.csv --device arm --restate -1s
try --csv table.csv --device arm --duration 0
try --csv table.csv --device arm --mtu 20
try --csv table.csv --device arm --demo all
try --demo crane
try --demo arm --columns a
