# A line of LOG.marks that is none is told with its number, when marks are asked for.
cp "$SRC/tests/data/logs/version-1.mcap" session.mcap
printf '# mine\n12.5 "no calendar time"\n' > session.mcap.marks
rocinante log cat session.mcap | wc -l
rocinante log cat session.mcap --channel '/rocinante/*'
