# A malformed line of LOG.marks is reported with its number when marks are requested.
cp "$SRC/tests/data/logs/version-1.mcap" session.mcap
printf '# mine\n12.5 "no calendar time"\n' > session.mcap.marks
rocinante log cat session.mcap | wc -l
rocinante log cat session.mcap --channel '/rocinante/*'
