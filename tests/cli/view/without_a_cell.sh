# A log without a cell is shown by itself: poses as axes with names, signals, plots; what needs a cell says so.
export ASAN_OPTIONS=detect_leaks=0
packets=()
for i in 0 1 2 3 4; do
  packets+=("${i}00:whole:RK1 tf@a $i -\npose map 0 0 0 0 0 0 1\npose base 0.$i 0 0 0 0 0 1\npose tool 0.$i 0.3 0.3 0 0 0 1\nsignal base battery 2$i.5 V\nsignal - estop false\nsignal plc mode \"auto\"\n")
done
make_pcap s.pcap "${packets[@]}"
printf '%s\n' 'panels on' 'select base' 'plot signal base battery' 'plot base:x' 'seek 0.3s' 'frame 2' 'fit' 'frame 2' 'screenshot shown.png' \
  'panels off' 'frame 2' 'screenshot bare.png' 'quit' >script.txt
look() { with_display rocinante view "$@" --size 640x480 --profile reproducible --script script.txt 2>&1 || echo "exit $?"; }
look s.pcap
rocinante golden compare shown.png bare.png --quiet | sed 's/:.*//' || true
printf 'evidence e.png\nquit\n' >script.txt
look s.pcap
# Joints by position, and a device that comes later.
make_pcap joints.pcap "000:whole:RK1 a@a 0 -\njoints arm 1 2\n" "500:whole:RK1 a@a 1 -\npose late 1 2 3 0 0 0 1\n"
printf 'seek 0s\nplot arm.2\nplot late:x\nplot d/dt arm.1\nquit\n' >script.txt
look joints.pcap
printf 'plot arm.3\nquit\n' >script.txt
look joints.pcap
