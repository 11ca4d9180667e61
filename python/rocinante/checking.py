"""Does this session fit this model?"""
from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Mapping

from ._programs import PathLike, options, run_json


@dataclass(frozen=True)
class Finding:
    """What one rule found about one subject; `rocinante check --explain RULE` explains the rule."""
    rule: str
    severity: str          #: "note", "warning" or "error"
    subject: str           #: the device, joint, source or file
    text: str              #: one sentence
    hint: str              #: what to do
    count: int             #: how often
    first: float | None    #: session time of the first, in seconds
    last: float | None
    is_accepted: bool      #: by the baseline
    document: Mapping[str, Any]
    is_of_pictures_only: bool = False  #: in the file of a mesh; links and joints move all the same

    def __str__(self) -> str:
        when = "" if self.first is None else f" at {self.first:.3f} s"
        return f"{self.severity} {self.rule}: {self.subject}{when}: {self.text} ({self.hint})"


if TYPE_CHECKING:
    _List = list[Finding]
else:
    _List = list


class Findings(_List):
    """All findings, and the verdict. Its text is for a failing test: `assert findings.ok, findings`."""

    def __init__(self, document: Mapping[str, Any], ok: bool) -> None:
        super().__init__(
            Finding(each["rule"], each["severity"], each.get("subject") or "", each["text"],
                    each.get("hint") or "", each["count"], each.get("first_s"), each.get("last_s"),
                    each["accepted"], each, each.get("pictures_only", False)) for each in document["findings"])
        self.document = document  #: all of it, as `rocinante check --json` prints it
        self.ok = ok              #: nothing is as severe as `fail_on`
        self.verdict: str = document["verdict"]

    def __str__(self) -> str:
        return "\n".join([f"{self.verdict}, {len(self)} findings", *(f"  {each}" for each in self)])


def check(cell: PathLike, log: PathLike | None = None, *, rules: Mapping[str, str] | None = None,
          fail_on: str = "error", baseline: PathLike | None = None, **more: Any) -> Findings:
    """Judges a session against a cell or model, or a cell alone; a log may carry its own cell.

    `rules` sets severities ({"joint.velocity": "off"}); other keywords are options of
    `rocinante check` (search=["models"]). Raises Error where nothing could be judged.
    """
    severities = [f"{rule}={severity}" for rule, severity in (rules or {}).items()]
    document = run_json("check", cell, *([] if log is None else [log]), "--json",
                        *options({"rule": severities, "fail_on": fail_on, "baseline": baseline, **more}),
                        verdicts=(0, 1))
    # By the program's own rule: findings that the baseline accepts do not count.
    grave = {"note": ("note", "warning", "error"), "warning": ("warning", "error"), "error": ("error",)}
    failing = any(each["severity"] in grave[document["fail_on"]] and not each["accepted"]
                  for each in document["findings"])
    return Findings(document, not failing)
