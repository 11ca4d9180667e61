# Prints the joints of every device whenever they change, by name where the source gave an order.
# python3 receiver.py 127.0.0.1 19960 [CHANGES]
import socket, sys, zlib
from urllib.parse import unquote
received = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
received.bind((sys.argv[1], int(sys.argv[2])))
print("listening on", received.getsockname()[1], flush=True)
most = int(sys.argv[3]) if len(sys.argv) > 3 else None
highest, orders, joints = {}, {}, {}  # highest: of a SOURCE its RUN and SEQUENCE

def is_newer(source, sequence):
    name, _, run = source.partition("@")
    last_run, last = highest.get(name, (None, -1))
    number = last + 1 if sequence == "-" else int(sequence)
    if run == last_run and last - 64 <= number <= last and number != 0:
        return False  # late or a duplicate; further below it is a restart
    highest[name] = (run, number)
    return True

while most is None or most > 0:
    lines = received.recv(65536).decode(errors="replace").splitlines()
    header = lines[0].split() if lines else []
    if len(header) < 4 or header[0] != "RK1" or not is_newer(header[1], header[2]):
        continue
    source = header[1].partition("@")[0]
    for line in lines[1:]:
        word, *fields = line.split() or [""]
        if word == "order" and fields:
            orders[source, fields[0]] = [unquote(name) for name in fields[1:]]
        if word != "joints" or len(fields) < 2:
            continue
        device, values = unquote(fields[0]), fields[1:]
        names = orders.get((source, fields[0])) or [str(i) for i in range(len(values))]
        if values[0].startswith("@"):  # only for the order of this tag
            tag = zlib.crc32("\n".join(names).encode())
            values = values[1:] if values[0].lower() == f"@{tag:08x}" else []
        if joints.get(device) != values and len(names) == len(values):
            joints[device] = values
            print(device, *(f"{name}={value}" for name, value in zip(names, values)), flush=True)
            most = None if most is None else most - 1
