rocinante record 127.0.0.1:0 -o empty.mcap --duration 0.05s --quiet
rocinante play empty.mcap --to 127.0.0.1:9
