echo "not a log" > notes.txt
rocinante log follow notes.txt || echo "exit $?"
rocinante log follow missing.mcap || echo "exit $?"
rocinante log follow . || echo "exit $?"
