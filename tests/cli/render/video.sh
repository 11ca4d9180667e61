# Raw pictures to ffmpeg, here one that only counts; what it says when it is missing or gives up.
log=$SRC/examples/demo/session.mcap
cell=$SRC/examples/demo/demo.cell.toml
mkdir bin
cat > bin/ffmpeg <<'SH'
#!/bin/sh
for last; do :; done
case "$*" in *"-framerate $RATE "*) ;; *) echo "not $RATE" >&2; exit 3 ;; esac
if [ "$MODE" = refuse ]; then head -c 100 >/dev/null; echo "Unknown encoder 'none'" >&2; exit 7; fi
if [ "$MODE" = die ]; then kill -9 $$; fi
wc -c > "${last#file:}"
SH
chmod +x bin/ffmpeg
PATH=$PWD/bin:$PATH
video() { rocinante-render $cell $log --size 32x24 --samples 1 --shading plain --video "$@" 2>&1 && echo "exit 0" || echo "exit $?"; }
export RATE=10
video out.mp4 --fps 10 --until 2s
tr -d ' ' < out.mp4
RATE=2 video half.webm --every 0.5s --until 2s --camera map --camera fit
cat half.map.webm half.fit.webm | tr -d ' '
RATE=2997/100 video ntsc.mkv --every 0.5s --fps 29.97 --until 1s
RATE=1 video events.mov --events
video out.mp4 --fps 10
MODE=refuse video refused.mp4 --fps 10
MODE=die video died.mp4 --fps 10
video out.avi
video out2.mp4 --fps 0
video out2.mp4 --fps fast
rocinante-render $cell $log --fps 10 --hash --at 1 2>&1 || echo "exit $?"
r=$(command -v rocinante-render)
PATH=/nowhere $r $cell $log --video none.mp4 2>&1 || echo "exit $?"
ls -A
