# Keys that went down between two frames are down in one: Ctrl, and V with it, paste.
export ASAN_OPTIONS=detect_leaks=0
echo '<robot name="arm"><link name="base"><visual><geometry><box size="1 1 1"/></geometry></visual></link></robot>' >arm.urdf
cat >script.txt <<'SCRIPT'
press ctrl+P
frame 4
clipboard screenshot%20pasted.png
press ctrl
press ctrl+V
frame 2
press enter
frame 4
SCRIPT
with_display rocinante view arm.urdf --size 320x240 --samples 1 --profile reproducible --script script.txt
ls *.png
