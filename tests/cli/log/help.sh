rocinante log --help | sed -n '1,2p'
