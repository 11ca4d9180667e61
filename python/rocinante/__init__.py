"""Rocinante in Python: recorded sessions of robots and simulators, as arrays, pictures and verdicts.

Everything is asked of the programs of Rocinante, found on PATH or in $ROCINANTE; nothing is compiled.
Arrays need NumPy. Times are seconds from the session's origin; lengths are metres, angles radians.

>>> import rocinante
>>> session = rocinante.Session("session.mcap", cell="demo.cell.toml")
>>> session.duration
19.990008348
>>> [event.text for event in session.events]
['picked', 'placed']
>>> arm = session.joints("arm")
>>> arm.names
('joint1', 'joint2', 'joint3', 'joint4', 'joint5', 'joint6')
>>> arm.values.shape == (len(arm.time), 6)
True
>>> rocinante.check("demo.cell.toml", "session.mcap").ok
True
"""
from ._programs import DamageWarning, Error, RocinanteWarning, program
from .checking import Finding, Findings, check
from .goldens import Comparison, compare, compare_sessions
from .pictures import Picture, render
from .processes import Player, Recorder, play, record
from .session import Columns, Device, Event, Poses, Session, Signal, State
from .source import Source

__all__ = [
    "Columns", "Comparison", "DamageWarning", "Device", "Error", "Event", "Finding", "Findings",
    "Picture", "Player", "Poses", "Recorder", "RocinanteWarning", "Session", "Signal", "Source", "State",
    "check", "compare", "compare_sessions", "play", "program", "record", "render",
]
