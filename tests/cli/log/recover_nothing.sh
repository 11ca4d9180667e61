# Where nothing can be read nothing is made.
echo 'not a log' > notes.txt
: > empty.mcap
head -c 40 "$SRC/tests/data/logs/version-1.mcap" > begun.mcap
for log in notes.txt empty.mcap begun.mcap nowhere.mcap .; do
  status=0
  rocinante log recover $log -o out.mcap || status=$?
  echo "exit $status"
done
ls
