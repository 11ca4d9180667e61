"""Sends kinematic state as packet text (docs/packet-format.md) over UDP."""
from __future__ import annotations

import math
import os
import socket
import time
from dataclasses import dataclass
from decimal import Decimal
from typing import Any, Iterable, Mapping, Sequence

_MOST_BYTES = 1200      # of a datagram: no network fragments it
_SPREAD_S = 0.5         # a restatement's parts leave within this; receivers drop them after 1 s
_PLAIN = frozenset(b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_.-:")


def _name(text: str, also: bytes = b"") -> str:
    data = text.encode()
    if not 1 <= len(data) <= 255 or any(byte < 32 or byte == 127 for byte in data):
        raise ValueError(f"not a name: {text!r} (1 to 255 bytes without control characters)")
    return "".join(chr(b) if b in _PLAIN or b in also else f"%{b:02X}" for b in data)


def _number(value: float) -> str:
    if not math.isfinite(value):
        raise ValueError(f"not a finite number: {value}")
    text = f"{value:.9f}".rstrip("0").rstrip(".")
    return "0" if text == "-0" else text


def _exact(value: float) -> str:
    """The fewest digits that read back as the same number; with an exponent below 1e-5 and from 2^53 on."""
    if not math.isfinite(value):
        raise ValueError(f"not a finite number: {value}")
    number = float(value)
    if number.is_integer() and abs(number) < 2**53:
        return str(int(number))
    digits = Decimal(repr(number))
    if 1e-5 <= abs(number) < 2**53:
        return f"{digits:f}"
    return f"{digits.normalize():e}".replace("e+", "e")


def _string(text: str) -> str:
    if len(text.encode()) > 4096 or any((ord(c) < 32 and c not in "\t\n") or ord(c) == 127 for c in text):
        raise ValueError("a text has at most 4,096 bytes and no control characters")
    return '"' + text.replace("\\", "\\\\").replace('"', '\\"').replace("\n", "\\n") + '"'


@dataclass
class _Number:
    """What a number of a signal is, and what receivers were sent last."""
    newest: float
    sent: float
    unit: str | None


def _signal_path(path: str | None) -> str:
    if path is None:
        return "-"
    if path.startswith("layer/"):
        raise ValueError(f"a signal has a device or a link, not a layer: {path}")
    return "%2D" if path == "-" else _name(path, b"/")


class Source:
    """A source of state: what changed goes out at each `flush`, and everything again every `restate` s,
    so that who joins late sees it too. Call `flush` in each cycle, at least ten times a second.

        with rocinante.Source("arm", to=("127.0.0.1", 19960)) as source:
            for q in trajectory:
                source.joints("arm", q)
                source.flush()
                time.sleep(0.01)
    """

    def __init__(self, name: str, to: tuple[str, int], *, restate: float = 2.0,
                 run: str | None = None) -> None:
        if restate <= 0:
            raise ValueError("restate is above 0 s")
        self.name = f"{_name(name)}@{_name(run or os.urandom(5).hex())}"
        self.restate = restate
        family, kind, protocol, _, self._to = socket.getaddrinfo(*to, type=socket.SOCK_DGRAM)[0]
        self._socket = socket.socket(family, kind, protocol)
        self._state: dict[tuple[str, ...], str] = {}    # what each line is about: the line
        self._changed: dict[tuple[str, ...], str] = {}
        self._once: list[str] = []                      # lines that are no state
        self._numbers: dict[tuple[str, ...], _Number] = {}  # of signals
        self._parts: list[tuple[float, str, list[tuple[str, ...]]]] = []
        self._sequence = self._restatements = 0
        self._next_restatement: float | None = None

    def __enter__(self) -> "Source":
        return self

    def __exit__(self, kind: Any, fault: Any, trace: Any) -> None:
        if kind is None:
            self.flush()
        self.close()

    def close(self) -> None:
        """Sends nothing more."""
        self._socket.close()

    def add(self, device: str, model: str) -> None:
        """The device exists; `model` is a name that the cell knows."""
        self._say(("add", device), f"add {_name(device)} {_name(model)}")

    def order(self, device: str, names: Sequence[str]) -> None:
        """Which joints `joints` means from now on."""
        self._say(("order", device), " ".join(["order", _name(device), *map(_name, names)]))

    def joints(self, device: str, values: Iterable[float] | Mapping[str, float]) -> None:
        """All joint values by position, in radians and metres; or some by name."""
        if isinstance(values, Mapping):
            for name, value in values.items():
                self._say(("joint", device, name), f"joint {_name(device)} {_name(name)}={_number(value)}")
            return
        words = [_number(value) for value in values]
        if not words:
            raise ValueError(f"no joint values for {device}")
        self._say(("joints", device), " ".join(["joints", _name(device), *words]))

    def pose(self, device: str, position: Sequence[float],
             orientation: Sequence[float] = (0.0, 0.0, 0.0, 1.0), parent: tuple[str, str] | None = None) -> None:
        """The pose of the device's base, metres and a quaternion x, y, z, w; in the world, or carried by
        `parent`, a device and its link."""
        if len(position) != 3 or len(orientation) != 4:
            raise ValueError("a pose has three coordinates and a quaternion of four numbers")
        carried = f" in {_name(parent[0])}/{_name(parent[1])}" if parent else ""
        numbers = " ".join(_number(value) for value in (*position, *orientation))
        self._say(("pose", device), f"pose {_name(device)} {numbers}{carried}")

    def show(self, path: str, visible: bool = True) -> None:
        """Shows or hides "DEVICE", "DEVICE/LINK" or "layer/NAME"."""
        self._say(("show", path), f"{'show' if visible else 'hide'} {_name(path, b'/')}")

    def color(self, path: str, color: str) -> None:
        """Colours DEVICE or DEVICE/LINK: "#rrggbb" or "#rrggbbaa"."""
        digits = color[1:]
        if color[:1] != "#" or len(digits) not in (6, 8) or any(c not in "0123456789abcdefABCDEF" for c in digits):
            raise ValueError(f"not a colour: {color!r} (#rrggbb or #rrggbbaa)")
        self._say(("color", path), f"color {_name(path, b'/')} {color}")

    def signal(self, path: str | None, name: str, value: float | bool | str | None, unit: str | None = None,
               *, deadband: float = 0.0) -> None:
        """A value that is no joint: of "DEVICE", "DEVICE/LINK", or None for neither. A number goes out when
        it differs by more than `deadband` from the one sent last, and is restated as it is; its unit is
        1 to 32 printable ASCII characters without spaces and quotes, by default the one it has. Receivers get
        the same number to the last bit. A value of None: nothing is said of it any more."""
        key = ("signal", path or "", name)
        words = f"signal {_signal_path(path)} {_name(name)}"
        if value is None:
            self._forget(lambda other: other == key)
            self._once.append(f"{words} default")
            return
        if isinstance(value, (bool, str)):
            if unit is not None:
                raise ValueError(f"{name}: only a number has a unit")
            self._numbers.pop(key, None)
            self._say(key, f"{words} {_string(value) if isinstance(value, str) else str(value).lower()}")
            return
        if unit is not None and not (1 <= len(unit) <= 32 and all("!" <= c <= "~" and c != '"' for c in unit)):
            raise ValueError(f"not a unit: {unit!r} (1 to 32 printable ASCII characters, no spaces, no quotes)")
        was = self._numbers.get(key)
        if unit is None and was is not None:
            unit = was.unit
        line = f"{words} {_exact(value)}" + (f" {unit}" if unit else "")
        if was is None or was.unit != unit or abs(value - was.sent) > deadband:
            self._say(key, line)
        else:
            self._state[key] = line     # restated, and sent only if it was to be sent anyway
            if key in self._changed:
                self._changed[key] = line
        self._numbers[key] = _Number(value, value if was is None else was.sent, unit)

    def label(self, id: str, position: Sequence[float], text: str) -> None:
        """Text at a point of the world."""
        x, y, z = position
        self._say(("drawing", id), f"label {_name(id)} {_number(x)} {_number(y)} {_number(z)} {_string(text)}")

    def line(self, id: str, points: Sequence[Sequence[float]], color: str = "#ffffff") -> None:
        """A line through points of the world; one that fits a datagram (about 40 points)."""
        numbers = " ".join(_number(value) for point in points for value in point)
        self._say(("drawing", id), f"line {_name(id)} {color} {numbers}")

    def erase(self, id: str) -> None:
        """Removes a drawing."""
        self._forget(lambda key: key == ("drawing", id))
        self._once.append(f"erase {_name(id)}")

    def remove(self, device: str) -> None:
        """The device is gone, with everything said about it."""
        self._forget(lambda key: key[0] != "drawing" and key[1].partition("/")[0] == device)
        self._once.append(f"remove {_name(device)}")

    def event(self, text: str) -> None:
        """Something happened."""
        self._once.append(f"event {_string(text)}")

    def flush(self) -> None:
        """Sends what changed since the last call, and the parts of a restatement that are due."""
        now = time.monotonic()
        # A removal comes before what was said after it; an event after the state that it speaks of.
        removals = [line for line in self._once if not line.startswith("event")]
        events = [line for line in self._once if line.startswith("event")]
        self._send_packed([*removals, *self._changed.values(), *events], "")
        self._note_sent(self._changed)
        self._changed, self._once = {}, []
        if self._next_restatement is None:
            self._next_restatement = now + self.restate
        if now >= self._next_restatement:
            self._begin_restatement(now)
        while self._parts and self._parts[0][0] <= now:
            _, words, keys = self._parts.pop(0)
            self._send([self._state[key] for key in keys if key in self._state], words)
            self._note_sent(keys)

    def _note_sent(self, keys: Iterable[tuple[str, ...]]) -> None:
        for key in keys:
            if number := self._numbers.get(key):
                number.sent = number.newest

    def _say(self, key: tuple[str, ...], line: str) -> None:
        if len(line.encode()) > _MOST_BYTES - 400:
            raise ValueError(f"{key[0]} of {key[1]} takes {len(line)} bytes, more than one datagram has")
        if self._state.get(key) != line:
            # A dictionary keeps the order in which keys came: an order precedes its joints.
            self._state[key] = self._changed[key] = line

    def _forget(self, is_gone: Any) -> None:
        stores: tuple[dict[tuple[str, ...], Any], ...] = (self._state, self._changed, self._numbers)
        for store in stores:
            for key in [key for key in store if is_gone(key)]:
                del store[key]

    def _begin_restatement(self, now: float) -> None:
        self._restatements += 1
        # Room for the words of a part, and for values that grow before it leaves.
        packed = self._pack(self._state.items(), 200)
        for i, keys in enumerate(packed):
            due = now + min(_SPREAD_S, self.restate / 4) * i / len(packed)
            self._parts.append((due, f" restated part=r{self._restatements}:{i + 1}/{len(packed)}", keys))
        self._next_restatement = max(now, self._next_restatement or now) + self.restate

    def _send_packed(self, lines: list[str], words: str) -> None:
        for group in self._pack(((line, line) for line in lines), 0):
            self._send(group, words)

    def _pack(self, lines: Iterable[tuple[Any, str]], room: int) -> list[list[Any]]:
        groups: list[list[Any]] = []
        free = 0
        for key, line in lines:
            size = len(line.encode()) + 1
            if size > free:
                groups.append([])
                free = _MOST_BYTES - len(self.name) - 64 - room
            groups[-1].append(key)
            free -= size
        return groups

    def _send(self, lines: list[str], words: str) -> None:
        text = f"RK1 {self.name} {self._sequence} {time.time_ns() / 1e9:.6f}{words}\n" + "".join(
            line + "\n" for line in lines)
        self._socket.sendto(text.encode(), self._to)
        self._sequence += 1
