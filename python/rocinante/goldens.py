"""Pictures and sessions against accepted ones."""
from __future__ import annotations

import io
import os
import tempfile
from dataclasses import dataclass
from typing import Any, Mapping

import numpy as np

from ._programs import PathLike, options, run_json
from .pictures import encode_png


@dataclass(frozen=True)
class Comparison:
    """A verdict, and everything that the program says of it."""
    ok: bool
    verdict: str                 #: same, different or incomparable
    document: Mapping[str, Any]  #: as `rocinante golden compare --json` or `golden session --json`


def png_bytes(picture: Any) -> bytes:
    """A PNG file of an array of bytes, of a PNG file's bytes, or of a figure (with `savefig`)."""
    if isinstance(picture, (bytes, bytearray)):
        return bytes(picture)
    if hasattr(picture, "savefig"):
        file = io.BytesIO()
        # No date and no version of the library in the file.
        picture.savefig(file, format="png", metadata={"Software": None})
        return file.getvalue()
    return encode_png(np.asarray(picture))


def compare(picture: Any, golden: PathLike, *, tier: str = "exact", mask: Any = None,
            difference: PathLike | None = None) -> Comparison:
    """Compares a picture (an array, a figure, PNG bytes) with an accepted file.

    `tier` is exact, rounding, cpu or loose; `mask` leaves out "X,Y,WIDTHxHEIGHT", one or a list;
    `difference` is a file for a picture of the differences.
    """
    with tempfile.TemporaryDirectory() as folder:
        frame = os.path.join(folder, "frame.png")
        with open(frame, "wb") as file:
            file.write(png_bytes(picture))
        document = run_json("golden", "compare", frame, golden, "--json",
                            *options({"tier": tier, "mask": mask, "difference": difference,
                                      "force": difference is not None}), verdicts=(0, 1, 2))
    return _judged(document)


def compare_sessions(accepted: PathLike, log: PathLike, cell: PathLike | None = None,
                     **more: Any) -> Comparison:
    """Compares a recording with an accepted one of the same scenario, aligned by their events.

    Other keywords are options of `rocinante golden session`: metres=0.002, slack="50ms", report=DIR.
    """
    return _judged(run_json("golden", "session", accepted, log, *([] if cell is None else [cell]), "--json",
                            *options(more), verdicts=(0, 1, 2)))


def _judged(document: Mapping[str, Any]) -> Comparison:
    return Comparison(document["verdict"] == "same", document["verdict"], document)
