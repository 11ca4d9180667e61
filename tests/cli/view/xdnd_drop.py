"""Drops files on a window, as a file manager does (XDND 5): xdnd_drop.py WINDOW FILE..."""
import sys
import time
from pathlib import Path

from Xlib import X, Xatom, display
from Xlib.protocol import event

target_id, files = int(sys.argv[1]), sys.argv[2:]
uris = "".join(Path(name).resolve().as_uri() + "\r\n" for name in files).encode()
screen = display.Display()
root = screen.screen().root
target = screen.create_resource_object("window", target_id)
source = root.create_window(0, 0, 1, 1, 0, X.CopyFromParent)
atom = screen.intern_atom
URI_LIST = atom("text/uri-list")


def send(kind, *data):
    target.send_event(event.ClientMessage(window=target, client_type=atom(kind),
                                          data=(32, [source.id, *data])))
    screen.flush()


source.set_selection_owner(atom("XdndSelection"), X.CurrentTime)
send("XdndEnter", 5 << 24, URI_LIST, 0, 0)
send("XdndPosition", 0, 100 << 16 | 100, X.CurrentTime, atom("XdndActionCopy"))
dropped = False
until = time.monotonic() + 60
while time.monotonic() < until:
    if not screen.pending_events():
        time.sleep(0.01)
        continue
    came = screen.next_event()
    if came.type == X.ClientMessage and came.client_type == atom("XdndStatus") and not dropped:
        if not came.data[1][1] & 1:
            sys.exit("the window does not take files")
        send("XdndDrop", 0, X.CurrentTime, 0, 0)
        dropped = True
    elif came.type == X.SelectionRequest:
        came.requestor.change_property(came.property, came.target, 8, uris)
        came.requestor.send_event(event.SelectionNotify(
            time=came.time, requestor=came.requestor, selection=came.selection,
            target=came.target, property=came.property))
        screen.flush()
    elif came.type == X.ClientMessage and came.client_type == atom("XdndFinished"):
        sys.exit(0)
sys.exit("the window did not take the files")
