# timeout(1) sends its signal to the recorder and to its group, so twice: the log is closed whole all the same.
timeout -s INT 1 rocinante record 127.0.0.1:0 -o log.mcap >/dev/null 2>&1 || echo "timeout says $?"
rocinante log info log.mcap | grep complete
