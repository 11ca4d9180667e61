# What docs/programs/source.md says of a joystick, with a file of its events.
python3 - <<'PY'
import struct
events = [(1000, 32767, 2, 0), (1000, 1, 1, 3), (1400, 0, 2, 0), (1500, -32767, 2, 1)]
open("events", "wb").write(b"".join(struct.pack("<IhBB", *event) for event in events))
PY
: >said
rocinante record 127.0.0.1:0 -o log.mcap >/dev/null 2>said &
recorder=$!
until grep -qs '^recording' said; do sleep 0.02; done
port=$(sed 's/.*:\([0-9]*\) to .*/\1/' said)
rocinante source --joystick events --to 127.0.0.1:"$port" --run r1 --quiet \
  --map axis0=arm.shoulder:0.5/s:-1.5..1.5 --map axis1=gripper.width:0..0.08 --map button3=event:pick
kill -INT $recorder
wait $recorder
# How often it was said between is the clock's; where it ended is not.
rocinante log cat log.mcap --format json >packets
grep -o 'event ..pick' packets
grep -o 'order [a-z ]*' packets | sort -u
grep -o 'joints arm [0-9.]*' packets | tail -n 1
grep -o 'joints gripper [0-9.]*' packets | sed -n '1p;$p'

printf 'nonsense, 17 bytes' >events
try() {
  status=0
  rocinante source --joystick events --to 127.0.0.1:9 --quiet "$@" 2>said || status=$?
  tail -n 1 said
  echo "$status"
}
try --map axis0=arm.shoulder:0.5/s
try --map axis0=arm:1/s
try --map axis0=arm.j
try --map knob=arm.j:1/s
try --map axis0=arm.j:1/s --device arm
try
