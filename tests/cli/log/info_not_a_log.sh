# A file that is not a log cannot be described.
echo 'not a log' > notes.txt
rocinante log info notes.txt
