# A log whose recorder was killed is described all the same; the exit code says it is not whole.
head -c 1200 "$SRC/tests/data/logs/version-1.mcap" > killed.mcap
rocinante log info killed.mcap
