try() {
  printf "$1" >table.csv
  shift
  rocinante source --csv table.csv --device arm --to 127.0.0.1:9 "$@" || echo "exit $?"
}
try 't,a,b\n0,1,2\n0.1,1\n'
try 't,a,b\n0,1,2\n0.1,1,0x2\n'
try 't,a\n0,nan\n'
try 'x,a\n0,1\n'
try 't,a\n1,1\n0.5,2\n'
try 't,a\nsoon,2\n'
try 't,a\n'
try ''
try 't,a\n0,1\n' --columns a,c
try 't,a,b,c,d\n0,1.00000000000001,2.00000000000002,3.00000000000003,4.00000000000004\n' --mtu 100
