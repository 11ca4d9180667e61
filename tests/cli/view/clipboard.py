"""Puts a text on the clipboard, says so, and serves it until another program takes the clipboard or this one is killed.
usage: clipboard.py TEXT"""
import sys

from Xlib import X, Xatom, display
from Xlib.protocol import event

here = display.Display()
window = here.screen().root.create_window(0, 0, 1, 1, 0, here.screen().root_depth)
clipboard, targets, utf8 = (here.intern_atom(name) for name in ("CLIPBOARD", "TARGETS", "UTF8_STRING"))
window.set_selection_owner(clipboard, X.CurrentTime)
here.sync()
print("ready", flush=True)
while True:
    asked = here.next_event()
    if asked.type == X.SelectionClear:
        break
    if asked.type != X.SelectionRequest:
        continue
    answered = asked.property if asked.property != X.NONE else asked.target
    if asked.target == targets:
        asked.requestor.change_property(answered, Xatom.ATOM, 32, [targets, utf8])
    elif asked.target == utf8:
        asked.requestor.change_property(answered, utf8, 8, sys.argv[1].encode())
    else:
        answered = X.NONE
    asked.requestor.send_event(event.SelectionNotify(
        time=asked.time, requestor=asked.requestor, selection=asked.selection, target=asked.target, property=answered))
    here.flush()
