"""Frames as arrays, and PNG files."""
from __future__ import annotations

import os
import struct
import tempfile
import zlib
from typing import TYPE_CHECKING, Any, Sequence

import numpy as np

from ._programs import Error, PathLike, Time, options, run_json, time_word

if TYPE_CHECKING:
    Bytes = np.ndarray[Any, np.dtype[np.uint8]]
else:
    Bytes = np.ndarray

_SIGNATURE = b"\x89PNG\r\n\x1a\n"


class Picture(Bytes):
    """An array of 8-bit RGBA, (height, width, 4), top row first, that a notebook shows as a picture."""

    def __new__(cls, pixels: Any) -> "Picture":
        return rgba(pixels).view(cls)

    def _repr_png_(self) -> bytes:
        return encode_png(self)

    def save(self, path: PathLike) -> None:
        """Writes it as a PNG file."""
        with open(path, "wb") as file:
            file.write(encode_png(self))


def rgba(pixels: Any) -> Bytes:
    """8-bit RGBA of an array of bytes: grey (H, W), RGB (H, W, 3) or RGBA (H, W, 4)."""
    array = np.asarray(pixels)
    if array.dtype != np.uint8:
        raise TypeError(f"a picture is of 8-bit numbers, not of {array.dtype}")
    if array.ndim == 2:
        array = np.repeat(array[:, :, None], 3, axis=2)
    if array.ndim != 3 or array.shape[2] not in (3, 4) or 0 in array.shape:
        raise TypeError(f"a picture is (H, W), (H, W, 3) or (H, W, 4), not {array.shape}")
    if array.shape[2] == 3:
        array = np.concatenate([array, np.full((*array.shape[:2], 1), 255, np.uint8)], axis=2)
    return np.ascontiguousarray(array)


def render(cell: PathLike, log: PathLike | None = None, *, at: Time | Sequence[Time] | None = None,
           size: tuple[int, int] = (640, 480), **more: Any) -> Any:
    """Draws a cell, at the moments `at` of a session. One moment gives a Picture, a list a list.

    Without a session the cell is drawn at rest. Other keywords are options of `rocinante render`:
    camera="side", shadows=True, hide=["layer/labels"], joints="arm=0 -0.785 0".
    """
    if "output" in more or "frames" in more:
        raise TypeError("render returns pictures; rocinante render writes files")
    several = isinstance(at, (list, tuple, np.ndarray))
    given: Any = [] if at is None else at
    moments = [time_word(t) for t in (given if several or at is None else [given])]
    if several and not moments:
        return []
    with tempfile.TemporaryDirectory() as folder:
        single = os.path.join(folder, "frame.png")
        document = run_json("render", cell, *([] if log is None else [log]), "--json",
                            *options({"at": moments, "size": f"{size[0]}x{size[1]}", **more}),
                            *(["--frames", folder] if several else ["-o", single]))
        files = [each["file"] for each in document["frames"]]
        if len(files) != (len(moments) if several else 1):
            raise Error(f"{len(files)} frames were drawn: several cameras are several calls")
        pictures = [Picture(decode_png(open_bytes(os.path.join(folder, os.path.basename(each)))))
                    for each in files]
    return pictures if several else pictures[0]


def open_bytes(path: PathLike) -> bytes:
    """The bytes of a file."""
    with open(path, "rb") as file:
        return file.read()


def encode_png(pixels: Any) -> bytes:
    """A PNG file of an array that `rgba` takes."""
    array = rgba(pixels)
    height, width = array.shape[:2]
    rows = np.zeros((height, 1 + width * 4), np.uint8)
    rows[:, 1:] = array.reshape(height, -1)

    def piece(kind: bytes, data: bytes) -> bytes:
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    return (_SIGNATURE + piece(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 6, 0, 0, 0)) +
            piece(b"IDAT", zlib.compress(rows.tobytes(), 6)) + piece(b"IEND", b""))


def decode_png(data: bytes) -> Bytes:
    """The array of a PNG file of 8-bit RGB or RGBA, as `rocinante render` writes it."""
    if data[:8] != _SIGNATURE:
        raise Error("not a PNG file")
    at, stored, head = 8, [], None
    while at + 12 <= len(data):
        size, kind = struct.unpack_from(">I4s", data, at)
        body = data[at + 8:at + 8 + size]
        if at + 12 + size > len(data):
            break
        if zlib.crc32(kind + body) != struct.unpack_from(">I", data, at + 8 + size)[0]:
            raise Error(f"byte {at}: a part of the PNG file is damaged")
        if kind == b"IHDR":
            head = struct.unpack(">IIBBBBB", body)
        elif kind == b"IDAT":
            stored.append(body)
        elif kind == b"IEND":
            break
        at += 12 + size
    if head is None or head[2] != 8 or head[3] not in (2, 6) or head[6] != 0:
        raise Error("not a PNG file of 8-bit RGB or RGBA without interlacing")
    width, height, channels = head[0], head[1], 4 if head[3] == 6 else 3
    row = 1 + width * channels
    unpacker = zlib.decompressobj()
    raw = unpacker.decompress(b"".join(stored), height * row)
    if len(raw) != height * row:
        raise Error(f"the PNG file ends early: {len(raw)} of {height * row} bytes of rows")
    rows = np.frombuffer(raw, np.uint8).reshape(height, row)
    return _unfiltered(rows[:, 1:].reshape(height, width, channels), rows[:, 0])


def _unfiltered(raw: Bytes, filters: Bytes) -> Bytes:
    """Undoes the filters of the rows. A pixel depends on those to its left and above it, so those of one
    diagonal are made at once."""
    if filters.max() > 4:
        raise Error(f"row {int(np.argmax(filters > 4))}: the PNG file has a filter {filters.max()}")
    height, width, channels = raw.shape
    out = np.zeros((height + 1, width + 1, channels), np.int16)
    kind = filters[:, None]
    for diagonal in range(height + width - 1):
        i = np.arange(max(0, diagonal - width + 1), min(height - 1, diagonal) + 1)
        j = diagonal - i
        left, above, corner = out[i + 1, j], out[i, j + 1], out[i, j]
        guess = left + above - corner
        to_left, to_above, to_corner = abs(guess - left), abs(guess - above), abs(guess - corner)
        paeth = np.where((to_left <= to_above) & (to_left <= to_corner), left,
                         np.where(to_above <= to_corner, above, corner))
        by = kind[i]
        add = np.where(by == 4, paeth, np.where(by == 3, (left + above) >> 1,
                       np.where(by == 2, above, np.where(by == 1, left, 0))))
        out[i + 1, j + 1] = (raw[i, j] + add) & 255
    return out[1:, 1:].astype(np.uint8)
