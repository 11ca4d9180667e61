# No library that draws can be loaded: said once, with what to install; nothing is judged of the rest.
mkdir lib
: >lib/libOSMesa.so.8
: >lib/libEGL.so.1
LD_LIBRARY_PATH=$PWD/lib rocinante --self-test --only context,key,frame >facts || echo "exit $?"
grep -o '^missing  context .*(libosmesa6)' facts
grep -v '^missing  context' facts
