# --version --parts: every optional part, in one order, and what it says is so in this build.
rocinante --version --parts >parts
head -n 1 parts
sed -n '2,$s/^  \([a-z0-9]*\) .*/\1/p' parts
folder=$(dirname "$(command -v rocinante)")
state() { awk -v part="$1" '$1 == part { print $2 }' parts; }
grep -vE '^(rocinante [0-9.]+|  [a-z0-9]+ +(on|off) +[^ ].*)$' parts || true
grep -E '^  [a-z0-9]+ +off ' parts | grep -vE ': (built without .|switched off: ROCINANTE_|needs ROCINANTE_)' || true
# A library with its version, where a part has one.
grep -E '^  (window|openimageio|pcap|nats|lz4|sqlite|zip|protobuf|sdf|osmesa) +on ' parts | grep -vE ': [A-Za-z0-9_]+ [0-9][0-9a-z.]*(, [A-Za-z0-9_]+ [0-9][0-9a-z.]*)*$' || true

same() { [ "$(state "$1")" = "$2" ] || echo "$1 is listed as $(state "$1"), and is $2"; }
there() { [ -e "$1" ] && echo on || echo off; }
same pictures "$(there "$folder/rocinante-render")"
same window "$(there "$folder/rocinante-view")"
same openimageio "$(there "$folder/../lib/librocinante_openimageio.so")"
same nats "$(there "$folder/../lib/librocinante_nats_client.so")"
same protobuf "$(there "$folder/../lib/librocinante_protobuf_messages.so")"
same sdf "$(there "$folder/../lib/librocinante_sdformat.so")"
said=$(rocinante record pcap://no-such-interface -o x.mcap 2>&1) || true
case $said in *"has no pcap://"*) same pcap off ;; *) same pcap on ;; esac

# Built, and its module is in another package.
if [ "$(state sdf)" = on ]; then
  grep -q '^  sdf *absent .*: librocinante_sdformat.so is not installed here$' <(ROCINANTE_MODULES=$PWD rocinante --version --parts) ||
    echo "a module that is not there is not told"
fi
said=$(ROCINANTE_MODULES=$PWD rocinante record nats://127.0.0.1:1/cell1 -o x.mcap 2>&1) || exit_code=$?
case "$exit_code $said" in
  "2 "*"(package rocinante-nats); librocinante_nats_client.so is not in $PWD"*) ;;
  *) echo "nats:// without its module: exit $exit_code: $said" ;;
esac
exit_code=0
said=$(ROCINANTE_MODULES=$PWD rocinante spy 127.0.0.1:0 --decoders "$SRC/examples/decoders/abb_egm.decoders.toml" \
  --duration 1s 2>&1) || exit_code=$?
case "$exit_code $said" in
  "2 "*"protobuf is not read without its module (package rocinante-protobuf); "*"is not in $PWD"*) ;;
  *) echo "protobuf without its module: exit $exit_code: $said" ;;
esac
rocinante --version --partz || echo "exit $?"
