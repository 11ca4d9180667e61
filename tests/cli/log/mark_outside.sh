# A moment outside the log is none.
cp "$SRC/tests/data/logs/version-1.mcap" session.mcap
rocinante log mark session.mcap 99s late || echo "exit $?"
rocinante log mark session.mcap soon late || echo "exit $?"
rocinante log mark session.mcap 0.5s "" || echo "exit $?"
rocinante log mark missing.mcap 0.5s x || echo "exit $?"
ls
