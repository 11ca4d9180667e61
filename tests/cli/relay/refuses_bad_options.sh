try() {
  status=0
  rocinante relay "$@" || status=$?
  echo "$status"
}
try
try --to nonsense
try --to 127.0.0.1:0
try --serve 239.1.2.3:5000
try --serve :0 --statement joints,wave
try --serve :0 --min-change joint=0
try --serve :0 --min-change speed=1
try --serve :0 --min-change 'signal =1'
try --serve :0 --max-rate fast
try --serve :0 --bandwidth 28.8x
try --serve :0 --bandwidth 100
try --serve :0 --bandwidth 28.8k,overhead=x
try --serve :0 --bandwidth 28.8k,8
try --serve :0 --restate 1ms
try --serve :0 --allow 10.0.0.5/8
try --serve :0 --name a:b
try --from 127.0.0.1:41999 --to 127.0.0.1:41999
