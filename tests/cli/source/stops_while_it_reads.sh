# SIGTERM ends it also where it reads a table that does not come.
mkfifo table.csv
exec 3<>table.csv
rocinante source --csv table.csv --device arm --to 127.0.0.1:9 2>said &
source=$!
# It catches SIGTERM, and SIGALRM for the case that nothing looks.
until grep -q '^SigCgt:.*[67ef][0-9a-f][0-9a-f][0-9a-f]$' /proc/$source/status; do
  kill -0 $source
  sleep 0.02
done
kill -TERM $source
wait $source || echo "exit $?"
sed 's/(.*//' said
