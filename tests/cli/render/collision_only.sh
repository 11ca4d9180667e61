# A model of a physics engine, with collision geometry alone: the hint shows it, and is not given again then.
echo '<robot name="c"><link name="l"><collision><geometry><box size="1 1 1"/></geometry></collision></link></robot>' >c.urdf
draw() { rocinante render c.urdf --size 64x48 --samples 1 -o "$@" 2>&1; }
draw empty.png
draw box.png --collision '*'
rocinante golden compare empty.png box.png | sed -n 1p | sed 's/:.*//' || echo "exit $?"
