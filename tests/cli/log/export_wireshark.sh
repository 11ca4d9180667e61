# tshark agrees with captures, checksums too, and the dissector shows what packets say.
command -v tshark >/dev/null || { echo "skipped: there is no tshark"; exit 77; }
export HOME=$PWD
rocinante log export "$SRC/examples/demo/session.mcap" --pcap -o session.pcap
lua=$SRC/share/wireshark/rocinante.lua
reader=()
echo 'print("a script")' >script.lua
if [ "$(tshark -r session.pcap -c 1 -X lua_script:script.lua 2>/dev/null | grep -c '^a script$')" = 0 ]; then
  # For root newer Wiresharks load no Lua: a user without rights reads it, where everybody may.
  command -v setpriv >/dev/null || { echo "skipped: tshark loads no Lua for this user, and there is no setpriv"; exit 77; }
  open=$(mktemp -d)
  trap 'rm -rf "$open"' EXIT
  cp "$lua" "$open"
  chmod -R a+rX "$open"
  lua=$open/rocinante.lua
  reader=(setpriv --reuid=65534 --regid=65534 --clear-groups env -i -C "$open" PATH="$PATH" HOME="$open")
fi
show() { "${reader[@]}" tshark -r - "$@" <session.pcap 2>/dev/null; }
show -o ip.check_checksum:TRUE -o udp.check_checksum:TRUE -T fields -e ip.checksum.status -e udp.checksum.status |
  sort | uniq -c | tr -s ' '
show -c 2 -T fields -e frame.time_epoch -e ip.src -e udp.srcport -e ip.dst -e udp.dstport
rocinante log cat "$SRC/examples/demo/session.mcap" --format csv | sed -n '2,3s/,.*//p'
show -X lua_script:"$lua" -c 3 -T fields -e rocinante.source -e rocinante.run \
  -e rocinante.sequence -e rocinante.kind -e rocinante.device -e rocinante.value
show -X lua_script:"$lua" -Y rocinante | wc -l
show -X lua_script:"$lua" -Y 'rocinante.kind == "event"' -T fields -e rocinante.text
show -X lua_script:"$lua" -Y rocinante.malformed | wc -l
# Signals: whose, its name, and a number with its unit, a truth or a text.
make_pcap session.pcap '0:whole:RK1 arm@a 0 -\nsignal arm/tool%200 load 5 kg\nsignal arm mode "auto run"\nsignals - estop=false width=0.25\nsignal arm old default\n'
show -X lua_script:"$lua" -T fields -e rocinante.kind -e rocinante.device -e rocinante.link -e rocinante.signal \
  -e rocinante.value -e rocinante.unit -e rocinante.truth -e rocinante.text | sed 's/False/0/'
