# A stop signal is followed while one frame is being drawn that takes very long.
python3 - >many.urdf <<'PY'
print('<robot name="spheres"><link name="base">')
for i in range(45000):
    print(f'<visual><origin xyz="{i % 100} {i // 100} 0"/><geometry><sphere radius="0.4"/></geometry></visual>')
print('</link></robot>')
PY
rocinante-render many.urdf --size 64x64 -o many.png &
render=$!
# Until it catches SIGTERM: bit 14 of what it catches.
until (($((16#$(sed -n 's/^SigCgt:\t*//p' /proc/$render/status))) & 16384)); do :; done
kill -TERM $render
wait $render || echo "exit $?"
ls many.png 2>/dev/null || echo "no picture"
