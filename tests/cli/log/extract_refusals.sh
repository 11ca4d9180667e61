# Nothing is replaced unless asked for, and no name leads out of the folder.
cp "$SRC/tests/data/logs/version-1.mcap" session.mcap
rocinante log extract session.mcap --all -o all || echo "exit $?"
rocinante log extract session.mcap --cell -o all || echo "exit $?"
printf 'one\n' >notes.md
rocinante log attach session.mcap notes.md -o with.mcap >/dev/null
rocinante log extract with.mcap gone.md -o - || echo "exit $?"
rocinante log extract with.mcap --index 3 -o - || echo "exit $?"
rocinante log extract with.mcap -o - || echo "exit $?"
rocinante log extract with.mcap notes.md --all -o x || echo "exit $?"
rocinante log extract with.mcap notes.md || echo "exit $?"
rocinante log extract with.mcap --list -o x || echo "exit $?"
rocinante log extract with.mcap notes.md -o notes.md || echo "exit $?"
rocinante log extract with.mcap notes.md -o notes.md --force
mkdir -p full && touch full/other
rocinante log extract with.mcap --all -o full || echo "exit $?"
rocinante log extract with.mcap --all -o full --force
ls full
# A name made by hand that leads out; as the attachment's checksum covers the name, that goes too.
python3 - <<'PY'
import struct, zlib
bytes_ = bytearray(open("with.mcap", "rb").read())
at = bytes_.find(b"\x08\0\0\0notes.md")
bytes_[at + 4 : at + 12] = b"../../up"
index = bytes_.rfind(b"\x08\0\0\0notes.md")
bytes_[index + 4 : index + 12] = b"../../up"
start = at - 16
data = bytes_.find(b"one\n", at) + 4
bytes_[data : data + 4] = struct.pack("<I", zlib.crc32(bytes_[start:data]))
footer = len(bytes_) - 8 - 20
summary = struct.unpack("<Q", bytes_[footer : footer + 8])[0]
bytes_[footer + 16 : footer + 20] = struct.pack("<I", zlib.crc32(bytes_[summary : footer + 16]))
open("hostile.mcap", "wb").write(bytes_)
PY
rocinante log extract hostile.mcap --all -o out || echo "exit $?"
rocinante log extract hostile.mcap --index 2 -o -
ls
