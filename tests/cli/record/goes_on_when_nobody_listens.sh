# Closed standard streams, a full disk behind them, a reader that has left: the recorder's messages are
# lost, and never written into the log; the recording continues to its end.
mkfifo left
exec 3<>left 4>left 3<&-  # a pipe whose reader has gone
for said in '>&-' '2>&-' '>&- 2>&-' '<&- >&- 2>&-' '>/dev/full 2>&1' '>&4 2>&4'; do
  rm -f session.mcap
  eval "rocinante record 127.0.0.1:0 -o session.mcap --status 10ms --duration 100ms $said" >/dev/null 2>&1 || echo "exit $?"
  echo "$said: $(rocinante log doctor session.mcap | grep -o "sound\|breach"), $(rocinante log info session.mcap | grep complete)"
done
