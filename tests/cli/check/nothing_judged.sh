# A session of which nothing can be decoded is never compatible.
printf '<robot name="arm"><link name="base"/></robot>' >arm.urdf
rocinante check arm.urdf --live 127.0.0.1:0 --duration 10ms 2>/dev/null | sed 's/:[0-9]*:/:PORT:/'
rocinante check arm.urdf --live 127.0.0.1:0 --duration 10ms >/dev/null 2>&1
