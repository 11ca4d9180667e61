# needs: shared
# Every file of the public conformance suite is sound.
ls "$SHARED"/mcap_conformance/*/*.mcap | wc -l
ls "$SHARED"/mcap_conformance/*/*.mcap | xargs rocinante-log doctor | grep -c ': sound '
