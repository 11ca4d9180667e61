# A disk that is full ends the work with a sentence and leaves nothing.
cp "$SRC/tests/data/logs/version-1.mcap" session.mcap
status=0
(ulimit -f 1; rocinante log cut session.mcap -o out.mcap --from 0s --compression none) || status=$?
echo "exit $status"
ls
