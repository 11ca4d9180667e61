# Every key of a style: the window at rest has the bytes that render draws, also with ghosts of a second session.
export ASAN_OPTIONS=detect_leaks=0
demo=$SRC/examples/demo
printf '%s\n' 'panels off' 'seek 7.5s' 'frame 2' 'screenshot window.png' 'evidence evidence.png' quit >script.txt
looks="shading=plain shadows=off contact=off edges=on labels=apart ghosts=clear limits=on clearance=on scale-bar=on
  camera-cone=off layer-looks=off outlined=canister wireframe=gantry transparent=arm/forearm@0.4 collision-over=arm
  trail=arm@3 axes=arm/tip measure=arm/tip@0,0,0~canister@0,0,0 lengths=m"
styles=()
for look in $looks; do styles+=(--style "$look"); done
compare() {
  rm -f ./*.png
  with_display rocinante view "$demo/demo.cell.toml" "$demo/session.mcap" --camera overview --size 480x360 \
    --profile reproducible --script script.txt "$@" 2>&1 | grep -v '^$' || true
  rocinante golden compare window.png evidence.png
}
compare "${styles[@]}"
compare "${styles[@]}" --beside "$demo/session.mcap" --align 1.5s
compare --style limits=on --beside "$demo/session.mcap" --align 1.5s
