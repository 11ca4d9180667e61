# A frame of more triangles than a software renderer bears is refused with a sentence; spheres of many sizes
# are one shape, scaled.
spheres() {
  python3 - "$1" <<'PY'
import sys
print('<robot name="spheres"><link name="base">')
for i in range(int(sys.argv[1])):
    print(f'<visual><origin xyz="{i % 100} {i // 100} 0"/><geometry>'
          f'<sphere radius="{0.005 + i * 1e-7:.7f}"/></geometry></visual>')
print('</link></robot>')
PY
}
spheres 46000 >many.urdf
rocinante render many.urdf --size 32x32 -o many.png || echo "exit $?"
rocinante model info many.urdf | grep geometry
spheres 1500 >few.urdf
rocinante model info few.urdf | grep geometry
# Beyond the first thousand sizes they are drawn as large as they are.
rocinante model info few.urdf | grep size
