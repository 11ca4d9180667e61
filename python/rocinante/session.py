"""Recorded sessions as arrays."""
from __future__ import annotations

import os
import tempfile
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Callable, Sequence

import numpy as np

from ._programs import Error, PathLike, Time, options, run, run_json, time_word
from .source import _name, _signal_path

if TYPE_CHECKING:
    from numpy.typing import NDArray


@dataclass(frozen=True)
class Event:
    """Something that a source, or a mark beside the log, says happened."""
    time: float     #: seconds from the session's origin
    source: str
    text: str
    time_ns: int    #: log time, nanoseconds since the epoch


@dataclass(frozen=True)
class Columns:
    """Joint values over time. Where a joint had no value yet, it is NaN."""
    time: NDArray[np.float64]      #: (N,) seconds from the session's origin
    names: tuple[str, ...]         #: of the joints; with a cell its own, else as the source orders them
    values: NDArray[np.float64]    #: (N, len(names)) radians, metres for sliding joints

    def __getitem__(self, name: str) -> NDArray[np.float64]:
        """The values of one joint, (N,)."""
        try:
            place = self.names.index(name)
        except ValueError:
            raise KeyError(f"no joint {name}; there are {', '.join(self.names)}") from None
        column: NDArray[np.float64] = self.values[:, place]
        return column


@dataclass(frozen=True)
class Poses:
    """Poses of a device's base or of a link over time. Before the first one they are NaN."""
    time: NDArray[np.float64]         #: (N,) seconds from the session's origin
    position: NDArray[np.float64]     #: (N, 3) metres, x forward, y left, z up
    orientation: NDArray[np.float64]  #: (N, 4) unit quaternions x, y, z, w


@dataclass(frozen=True)
class Signal:
    """A signal over time: numbers, or booleans as 1 and 0. Where it had no value yet, it is NaN."""
    time: NDArray[np.float64]      #: (N,) seconds from the session's origin
    values: NDArray[np.float64]    #: (N,) in the unit
    unit: str | None               #: at the end of the session; None: none is stated there
    # Numbers in another unit before that are named by a RocinanteWarning, with both units and the time.


@dataclass(frozen=True)
class Device:
    """What the packets up to a moment say about one device."""
    joints: tuple[float, ...] | None            #: by position, where a source sends them so
    named_joints: dict[str, float]              #: by name
    position: tuple[float, float, float] | None
    orientation: tuple[float, float, float, float] | None
    parent: tuple[str, str] | None              #: the device and link that carry it; None: the world


@dataclass(frozen=True)
class State:
    """The folded state at a moment."""
    time: float
    devices: dict[str, Device]  #: those that are there
    document: dict[str, Any]  #: all of it, as `rocinante log state --json` prints it


def _signal_name(path: str | None, name: str) -> str:
    return f"signal {_signal_path(path)} {_name(name)}"


def _stated_name(device: str | None, link: str | None, name: str) -> str:
    """As packets write it, of names as they are."""
    if device is None:
        path = "-"
    elif link is None:
        path = "%2D" if device == "-" else _name(device)
    else:
        path = ("%6Cayer" if device == "layer" else _name(device)) + "/" + _name(link)
    return f"signal {path} {_name(name)}"


def _poses_of(table: dict[str, NDArray[Any]], before: str, after: str) -> Poses:
    """Of the seven columns whose names have this before and after the part of the pose."""
    columns = [np.column_stack([table[before + axis + after] for axis in axes])
               for axes in (("x", "y", "z"), ("qx", "qy", "qz", "qw"))]
    return Poses(table["t"], *columns)


class Session:
    """A log. `cell` is the cell or model that names its joints; by default the one that the log carries.

    Damage of the log is a DamageWarning wherever an answer leaves something out because of it.
    """

    def __init__(self, log: PathLike, cell: PathLike | None = None) -> None:
        self.log = os.fspath(log)
        self.cell = None if cell is None else os.fspath(cell)
        self._imported: tempfile.TemporaryDirectory[str] | None = None  # holds the log while it is read
        #: what `rocinante log info --json` prints
        self.info: dict[str, Any] = self._open()
        self._event_list: list[dict[str, Any]] = self.info["event_list"]

    def _open(self) -> dict[str, Any]:
        """The log's info. What another program recorded becomes the log that `log import` makes of it."""
        info = None
        try:
            info = run_json("log", "info", "--json", self.log)
        except Error:
            if not os.path.exists(self.log):
                raise
        if info is not None and info["profile"] == "rocinante":
            return info
        folder = tempfile.TemporaryDirectory()
        log = os.path.join(folder.name, "session.mcap")
        try:
            run("log", "import", self.log, "-o", log, *options({"cell": self.cell}))
        except Error:
            # An MCAP file with packets of ours, by another writer.
            if info is None:
                raise
            return info
        self._imported, self.log = folder, log
        return run_json("log", "info", "--json", log)

    def __repr__(self) -> str:
        return f"<Session {self.log}, {self.duration:.3f} s, {self.info['messages']} messages>"

    @property
    def duration(self) -> float:
        """Seconds from the first message to the last."""
        return float(self.info["duration_s"])

    @property
    def origin_ns(self) -> int:
        """Log time of 0 s, in nanoseconds since the epoch."""
        return int(self.info["origin_ns"])

    @property
    def sources(self) -> list[str]:
        """The names of the sources that speak in it."""
        return sorted({channel["source"] for channel in self.info["channels"] if channel.get("source")})

    @property
    def events(self) -> list[Event]:
        """All events and marks, in the order of time."""
        if len(self._event_list) < self.info["events"]:  # the info has the first 1,000
            self._event_list = run_json("log", "info", "--json", "--all-events", self.log)["event_list"]
        return [Event((each["log_time_ns"] - self.origin_ns) / 1e9, each.get("source") or "", each["text"],
                      each["log_time_ns"]) for each in self._event_list]

    def table(self, device: str | None = None, *, signals: bool = False, links: Sequence[str] = (),
              frame: str | None = None, derive: Sequence[str] = (), every: Time | None = None,
              start: Time | None = None, end: Time | None = None) -> dict[str, NDArray[Any]]:
        """The columns of `rocinante log table`, by name: `t`, `t_ns`, `DEVICE.JOINT`, `DEVICE:x` ...;
        with `signals` also `signal PATH NAME`, numbers, and booleans as 1 and 0; with `links` also
        `DEVICE/LINK:x` ..., or `DEVICE/LINK:x in FRAME` ... in the frame of a device or link; with
        `derive` also what is derived, by its own words: `d/dt arm.joint1`, `mean 0.5 arm:x`, `arm.a - arm.b`.

        One row for each moment that writes a value, or one at each multiple of `every`; from `start`
        until before `end`.
        """
        with tempfile.TemporaryDirectory() as folder:
            table = os.path.join(folder, "table.npz")
            run("log", "table", self.log, "-o", table, *(["--signals"] if signals else []),
                *(f"--link={link}" for link in links), *(f"--derive={value}" for value in derive), *options({
                "device": device, "cell": self.cell, "in": frame,
                "every": None if every is None else time_word(every),
                "from": None if start is None else time_word(start),
                "until": None if end is None else time_word(end)}))
            with np.load(table) as archive:
                return {name: archive[name] for name in archive.files}

    def joints(self, device: str, **span: Any) -> Columns:
        """The joint values of a device; `every`, `start` and `end` as for `table`."""
        table = self._of_device(device, span)
        begin = device + "."
        names = tuple(name[len(begin):] for name in table if name.startswith(begin))
        if not names:
            raise KeyError(f"{self.log} has no joint values of a device {device}" + self._those_with(
                lambda each: bool(each["joints"] or each["named_joints"])))
        return Columns(table["t"], names, np.column_stack([table[begin + name] for name in names]))

    def poses(self, device: str, **span: Any) -> Poses:
        """The poses of a device's base; `every`, `start` and `end` as for `table`."""
        table = self._of_device(device, span)
        if device + ":x" not in table:
            raise KeyError(f"{self.log} has no pose of a device {device}" + self._those_with(
                lambda each: bool(each["pose"])))
        return _poses_of(table, f"{device}:", "")

    def link(self, path: str, frame: str | None = None, **span: Any) -> Poses:
        """The poses of a link, "DEVICE/LINK", in the world, or in the frame of a device or link; `every`,
        `start` and `end` as for `table`. It needs a cell."""
        device = path.split("/")[0]
        table = self._of_device(device, {"links": [path], "frame": frame, **span})
        return _poses_of(table, f"{path}:", "" if frame is None else f" in {frame}")

    @property
    def signals(self) -> dict[str, float | bool | str]:
        """The signals at the end of the session by name, `signal PATH NAME`: numbers, truths, texts."""
        return {name: each["value"] for name, each in self._signals_at_end().items()}

    def signal(self, path: str | None, name: str, **span: Any) -> Signal:
        """A signal of "DEVICE", "DEVICE/LINK", or "-" (or None) for neither; `every`, `start` and `end`
        as for `table`. One of texts has no numbers: `signals` and `state` have them."""
        path = None if path == "-" else path
        called = _signal_name(path, name)
        table: dict[str, NDArray[Any]] = {}
        try:
            if path is None:
                table = self.table(signals=True, **span)
            else:
                table = self._of_device(path.split("/")[0], {"signals": True, **span})
        except Error as error:
            if "no chosen device has" not in str(error):
                raise
        at_end = self._signals_at_end()
        if called in table:
            return Signal(table["t"], table[called], at_end[called]["unit"] if called in at_end else None)
        if called in at_end:
            raise KeyError(f"{called} has texts: {at_end[called]['value']!r} at the end")
        others = ", ".join(at_end)
        raise KeyError(f"{self.log} has no {called}" + (f"; there are {others}" if others else ""))

    def _signals_at_end(self) -> dict[str, dict[str, Any]]:
        document = self.state((self.info["end_ns"] - self.origin_ns) / 1e9).document
        found = {}
        for device in [*document["devices"], {"name": None, "signals": document["signals"]}]:
            for each in device["signals"]:
                found[_stated_name(device["name"], each["link"], each["name"])] = each
        return found

    def state(self, at: Time) -> State:
        """The state at a moment: what every packet up to it says, folded."""
        document = run_json("log", "state", self.log, f"--at={time_word(at)}", "--json")
        devices = {}
        for each in document["devices"]:
            if each["presence"] and each["presence"]["is"] == "removed":
                continue
            pose, joints = each["pose"], each["joints"]
            x, y, z = pose["position_m"] if pose else (0, 0, 0)
            qx, qy, qz, qw = pose["orientation_xyzw"] if pose else (0, 0, 0, 1)
            devices[each["name"]] = Device(
                tuple(joints["values"]) if joints else None,
                {joint["name"]: joint["value"] for joint in each["named_joints"]},
                (x, y, z) if pose else None,
                (qx, qy, qz, qw) if pose else None,
                (pose["in"]["device"], pose["in"]["link"]) if pose and pose["in"] else None)
        return State((document["at_ns"] - document["origin_ns"]) / 1e9, devices, document)

    def _those_with(self, has: Callable[[dict[str, Any]], bool]) -> str:
        """"; there are a, b": the devices at the end of which this is true, for a message."""
        end = self.state((self.info["end_ns"] - self.origin_ns) / 1e9).document["devices"]
        names = ", ".join(each["name"] for each in end if has(each))
        return f"; there are those of {names}" if names else ""

    def _of_device(self, device: str, span: dict[str, Any]) -> dict[str, NDArray[Any]]:
        # A name is a pattern that matches itself alone once its marks are escaped (docs/patterns.md).
        return self.table("".join("\\" + c if c in "\\*?[" else c for c in device), **span)
