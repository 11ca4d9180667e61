# timeout(1) hands its signal to the recorder and to its group, so twice: the log is closed whole all the same.
timeout -s INT 60 rocinante record 127.0.0.1:0 -o log.mcap >/dev/null 2>said &
until grep -qs '^recording' said; do kill -0 $!; sleep 0.02; done
kill -INT $!
wait $! && echo "exit 0"
rocinante log info log.mcap | grep complete
