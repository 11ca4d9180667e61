# What is attached comes out as it went in; the log it was attached to stays as it is.
cp "$SRC/tests/data/logs/version-1.mcap" session.mcap
printf 'the gripper slipped\n' >notes.md
head -c 100000 /dev/zero >zeros.bin
rocinante log attach session.mcap notes.md zeros.bin -o with.mcap
cmp session.mcap "$SRC/tests/data/logs/version-1.mcap"
rocinante log extract with.mcap --list
rocinante log extract with.mcap notes.md -o -
rocinante log extract with.mcap --index 3 -o out.bin && cmp zeros.bin out.bin && echo "the same bytes"
rocinante log extract with.mcap --all -o all && ls all
rocinante log attach with.mcap notes.md -o again.mcap --name logs/notes.txt --media-type text/x-notes
rocinante log extract again.mcap --list --json
test "$(rocinante log cat again.mcap --format json)" = "$(rocinante log cat session.mcap --format json)" && echo "the same messages"
for log in session again; do rocinante log info --json $log.mcap | grep -E '"(session_id|content_sha256)"'; done | sort -u | wc -l
