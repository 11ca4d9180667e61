# A log that is closed already: its messages if requested, and the end.
cp "$SRC/tests/data/logs/version-1.mcap" session.mcap
rocinante log follow session.mcap
rocinante log follow session.mcap --from-start --channel '/udp/*/planner' --channel '/rocinante/*'
rocinante log follow session.mcap --from-start --format json >followed.json
rocinante log cat session.mcap --format json >cat.json
cmp followed.json cat.json
rocinante log follow session.mcap --from-start --format csv >followed.csv
rocinante log cat session.mcap --format csv >cat.csv
cmp followed.csv cat.csv
