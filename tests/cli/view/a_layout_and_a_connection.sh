# A layout of the command line is that of what a script connects to first, which is listened to from then on: nothing is
# missed yet.
export ASAN_OPTIONS=detect_leaks=0 XDG_CACHE_HOME=$PWD/cache
printf '%s\n' 'format = 1' 'theme = "light"' >light.layout.toml
printf '%s\n' 'wait 3' "connect 127.0.0.1:$((20000 + ($$ + 29) % 20000))" 'dismiss' 'frame 1' 'await-line' 'save-layout shown' >script.txt
with_display rocinante view --layout light.layout.toml --size 320x240 --profile reproducible --script script.txt
grep theme shown.layout.toml
