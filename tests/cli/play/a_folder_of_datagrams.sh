# A folder with a datagram a file is played like a log of them; a bag has none.
mkdir raw bag
printf 'RK1 a@b 1 -\njoints arm 0.5\n' >raw/1700000001.txt
printf 'RK1 a@b 2 -\njoints arm 0.6\n' >raw/1700000001.25.txt
rocinante play raw --to udp://127.0.0.1:9 --speed 100 --json 2>said | grep -E '"(datagrams|sent|inputs)"|raw' | sort | uniq
cat said
