"""Pictures and sessions against accepted ones."""
from __future__ import annotations

import io
import os
import tempfile
from dataclasses import dataclass, field
from typing import Any, Mapping, Sequence, Union

import numpy as np

from ._programs import PathLike, options, run_json
from .pictures import encode_png

#: of a verdict's text, after its first
MOST_LINES = 8


@dataclass(frozen=True)
class Comparison:
    """A verdict. Its text is for a failing test: `assert judged.ok, judged`."""
    ok: bool
    verdict: str                 #: same, different or incomparable
    #: all of it, as `rocinante golden compare --json` or `golden session --json` prints it
    document: Mapping[str, Any] = field(repr=False)

    @property
    def reasons(self) -> list[str]:
        """What decided, a sentence each, the first cause first: the joint, by how much, since when."""
        run = self.document.get("run")
        if run is None:
            figures = ""
            if self.document.get("differing"):
                figures = (f" ({self.document['differing']} differing pixels, "
                           f"at most {self.document['max']} of 255)")
            return [self.document["rule"] + figures]
        lines = [each["what"] for each in run["findings"]] or [run["rule"]]
        lines += run["changes"]
        lines += [f"picture {each['name']}: {each['rule']}" for each in self.document.get("pictures") or []
                  if each["verdict"] != "same"]
        if self.document.get("damage"):
            lines.append(self.document["damage"])
        return lines

    def __str__(self) -> str:
        first, *rest = self.reasons
        return "\n  ".join([f"{self.verdict}: {first}", *rest[:MOST_LINES],
                            *([f"... and {len(rest) - MOST_LINES} more"] if len(rest) > MOST_LINES else [])])


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


def compare_sessions(accepted: Union[PathLike, Sequence[PathLike]], log: PathLike,
                     cell: PathLike | None = None, *, pictures: bool = True, **more: Any) -> Comparison:
    """Compares a recording with an accepted one of the same scenario, aligned by their events.

    Several accepted ones are a band: what lies between them is the same. Without `pictures` behaviour
    alone is judged, and nothing is drawn. Other keywords are options of `rocinante golden session`:
    joint_deg=0.2, position_mm=2, event_ms=50, report=DIR.
    """
    first, *others = [accepted] if isinstance(accepted, (str, os.PathLike)) else accepted
    return _judged(run_json("golden", "session", first, log, *([] if cell is None else [cell]), "--json",
                            *options({"accepted": others, "no_pictures": not pictures, **more}),
                            verdicts=(0, 1, 2)))


def _judged(document: Mapping[str, Any]) -> Comparison:
    return Comparison(document["verdict"] == "same", document["verdict"], document)
