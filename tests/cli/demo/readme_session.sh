# The session that README.md shows, as it stands there, on a port that is free.
awk '/readme_session.sh runs this block/ {found = 1} found && /^```/ {if (inside) exit; inside = 1; next} inside' \
  "$SRC/README.md" >block.sh
port=$(python3 -c 'import socket; s = socket.socket(socket.AF_INET, socket.SOCK_DGRAM); s.bind(("127.0.0.1", 0)); print(s.getsockname()[1])')
sed -i "s/19960/$port/" block.sh
ln -s "$SRC/examples" examples
bash -eu -o pipefail block.sh >said 2>errors
grep -c '' block.sh
grep '^compatible' said
ls moment.png session.mcap
