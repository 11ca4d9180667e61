# Every key of a style: the window at rest has the bytes that render draws of the same words, and of those that the window
# itself writes; with a second session beside and alone, with shadows and contact, as a line drawing, and with plain shading.
# A key that no look here sets is a difference.
export ASAN_OPTIONS=detect_leaks=0
demo=$SRC/examples/demo
cat >block.urdf <<'URDF'
<robot name="block"><link name="body">
  <visual><geometry><box size="0.5 0.5 0.5"/></geometry></visual>
  <collision><geometry><sphere radius="0.4"/></geometry></collision>
</link></robot>
URDF
cat >looks.cell.toml <<TOML
format = 1
include = ["demo.cell.toml"]
search = ["$demo"]
[[device]]
name = "shell"
model = "block.urdf"
layer = "robots"
pose = { xyz = [0.9, -2.2, 0.5] }
[[device]]
name = "block"
model = "block.urdf"
layer = "robots"
pose = { xyz = [-0.3, -2.2, 0.5] }
[[layer]]
name = "tanks"
opacity = 0.5
[[inset]]
camera = "top"
size = [0.25, 0.25]
[[clearance]]
between = ["arm", "gantry"]
min_m = 0.5
TOML
# Beside a second session, ghosts are clear by themselves.
lit="shadows=on contact=on edges=on labels=apart limits=on clearance=on scale-bar=on camera-cone=on layer-looks=off
  outlined=canister wireframe=gantry transparent=arm/forearm@0.4 collision=block collision-over=shell trail=arm@3
  axes=arm/tip measure=arm/tip@0,0,0~canister@0,0,0 lengths=m"
lines="edges=only"
plain="shading=plain ghosts=clear"

words=()
style() { for look in $1; do words+=(--style "$look"); done; }
add_case() {
  words=()
  style "$2"
  rocinante golden add looks.suite.toml --cell looks.cell.toml --case "$1" "${words[@]}" >added.txt
}
add_case lit "$lit"
add_case lines "$lines"
add_case plain "$plain"
# A suite has only what differs from the default.
grep '^style = ' looks.suite.toml | grep -oE '[{,] [a-z-]+ = ' | tr -d '{,= ' | sort -u >looked.txt
{ rocinante golden add looks.suite.toml --case none --style no-such-key 2>&1 || true; } |
  sed -n 's/.*the styles are: //p' | tr -d ' ' | tr ',' '\n' | sort >keys.txt
diff keys.txt looked.txt && echo "every key has a look"

cat >script.txt <<'SCRIPT'
panels off
seek 7.5s
frame 2
screenshot beside.png
style edges only
frame 2
screenshot lines.png
evidence lines-evidence.png
beside off
style edges on
frame 2
screenshot lit.png
evidence lit-evidence.png
style shadows off
style contact off
style shading plain
style ghosts clear
frame 2
screenshot plain.png
evidence plain-evidence.png
quit
SCRIPT
beside=(--beside "$demo/session.mcap" --align 1.5s)
words=()
style "$lit"
with_display rocinante view looks.cell.toml "$demo/session.mcap" --camera overview --size 480x360 \
  --profile reproducible --script script.txt "${words[@]}" "${beside[@]}" 2>&1 | grep -v '^$' || true
rocinante render looks.cell.toml "$demo/session.mcap" --camera overview --size 480x360 --at 7.5s \
  $(printf -- '--%s ' $lit) "${beside[@]}" -o beside-render.png
rocinante golden compare beside.png beside-render.png
for look in lines lit plain; do rocinante golden compare $look.png $look-evidence.png; done
