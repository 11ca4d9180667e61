# Nothing judged is never yes.
echo "not a log" > notes.txt
rocinante log doctor notes.txt || echo "exit $?"
rocinante log doctor missing.mcap || echo "exit $?"
: > empty.mcap
rocinante log doctor empty.mcap || echo "exit $?"
