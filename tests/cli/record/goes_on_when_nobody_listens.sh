# Closed standard streams, a full disk below them, a reader that has left: what the recorder says is
# lost, and least of all written into the log; the recording goes on to its end.
for said in '>&-' '2>&-' '>&- 2>&-' '<&- >&- 2>&-' '>/dev/full 2>&1' '2>&1 | head -n 1'; do
  rm -f session.mcap
  eval "rocinante record 127.0.0.1:0 -o session.mcap --status 10ms --duration 100ms $said" >/dev/null 2>&1 || true
  echo "$said: $(rocinante log doctor session.mcap | grep -o "sound\|breach"), $(rocinante log info session.mcap | grep complete)"
done
