# What it does not know is an error of one sentence, and nothing is judged.
for words in "--only frame,light" "--only" "--all" "frame"; do
  rocinante --self-test $words || echo "exit $?" >&2
done
