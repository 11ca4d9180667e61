rocinante spy --help | head -3
