# The sender that README.md shows, as it stands there but shorter, on a port that is free.
awk '/readme_sender.sh runs this block/ {found = 1} found && /^```/ {if (inside) exit; inside = 1; next} inside' \
  "$SRC/README.md" >sender.py
sed -i 's/range(200)/range(20)/' sender.py
rocinante record 127.0.0.1:0 -o session.mcap --max-packets 20 --duration 90s --min-packets 20 >/dev/null 2>listening &
until grep -qs '^recording' listening; do kill -0 $!; sleep 0.05; done
sed -i "s/19960/$(grep -o '[0-9]* to session' listening | cut -d' ' -f1)/" sender.py
python3 sender.py
wait $! || echo "exit $?"
rocinante log cat session.mcap --device arm | tail -n 1 | sed 's/.*joints/joints/'
