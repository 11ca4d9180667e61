# A driver that crashes, or prints nonsense, costs what draws and nothing else.
bin=$(dirname "$(command -v rocinante)")
mkdir bin
cp "$bin"/rocinante "$bin"/rocinante-self-test bin
try() {
  printf '#!/bin/sh\n%s\n' "$1" >bin/rocinante-self-test-draw
  chmod +x bin/rocinante-self-test-draw
  bin/rocinante --self-test --only frame,multicast || echo "exit $?"
}
try 'kill -SEGV $$'
try 'echo MESA: error: no memory; exit 3'
try 'yes | head -c 3000000'
