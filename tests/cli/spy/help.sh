rocinante spy --help | sed -n 1,3p
