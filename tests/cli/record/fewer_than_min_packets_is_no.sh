rocinante record 127.0.0.1:0 -o log.mcap --duration 0.05s --min-packets 1 --quiet
