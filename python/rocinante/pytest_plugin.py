"""A fixture `golden` for pytest: pictures and sessions against accepted ones.

    def test_gauge(golden):
        golden.check(draw_gauge(), "gauge")

    def test_pick(golden):
        golden.session("out/pick.mcap", "cell.toml")

Accepted files lie in the folder `goldens` beside the test. `pytest --golden-approve` accepts what would
fail, in place of what was accepted; `pytest --golden-widen` accepts sessions beside it, so that what
lies between them is the same. A session in which `rocinante check` finds errors is accepted with
`--golden-anyway` alone. All are refused where CI is set. Every run leaves one page of all verdicts,
`golden-results/index.html`.
"""
from __future__ import annotations

import html
import os
import pathlib
import re
import shutil
from dataclasses import dataclass
from typing import Any, Callable, Mapping

import pytest

from ._programs import Error
from .checking import check
from .goldens import MOST_LINES, Comparison, compare, compare_sessions, png_bytes

_PAGE = """<!doctype html><meta charset="utf-8"><title>Goldens</title>
<style>body{font:15px sans-serif;margin:2em auto;max-width:72em;color:#222;background:#fff}
figure{display:inline-block;margin:0 1em 1em 0}img{max-width:22em;border:1px solid #ccc;image-rendering:pixelated}
section{border-top:1px solid #ccc;padding:.6em 0}.failed h2{color:#b00020}h2{font-size:1.1em}
.files{color:#666;font-size:.85em}</style>
"""


def pytest_addoption(parser: Any) -> None:
    group = parser.getgroup("rocinante")
    group.addoption("--golden-approve", action="store_true",
                    help="accept pictures and sessions that would fail (refused where CI is set)")
    group.addoption("--golden-widen", action="store_true",
                    help="accept sessions that would fail beside those accepted before: what lies between "
                         "them is the same (refused where CI is set)")
    group.addoption("--golden-anyway", action="store_true",
                    help="with one of these: also sessions in which `rocinante check` finds errors")
    group.addoption("--golden-dir", help="folder of accepted files (default: goldens beside each test)")
    group.addoption("--golden-results", default="golden-results",
                    help="folder of failing frames and of the page of all verdicts")


@dataclass(frozen=True)
class _Section:
    """One verdict of the page."""
    name: str
    ok: bool
    lines: list[str]
    files: list[tuple[str, pathlib.Path]]


class _Verdicts:
    """All verdicts of a run, and their page."""

    def __init__(self, folder: pathlib.Path) -> None:
        self.folder = folder
        self.sections: list[_Section] = []

    def write(self) -> None:
        self.folder.mkdir(parents=True, exist_ok=True)
        failed = sum(not section.ok for section in self.sections)
        page = [_PAGE, f"<h1>{len(self.sections)} verdicts, {failed} failed</h1>"]
        for section in sorted(self.sections, key=lambda each: each.ok):
            first, *rest = section.lines
            page.append(f'<section class="{"passed" if section.ok else "failed"}">'
                        f"<h2>{html.escape(section.name)}</h2><p>{html.escape(first)}</p>")
            if rest:
                page.append("<ul>" + "".join(f"<li>{html.escape(line)}</li>" for line in rest) + "</ul>")
            others = []
            for title, file in section.files:
                link = html.escape(os.path.relpath(file, self.folder), quote=True)
                if file.suffix in (".png", ".html"):
                    shown = f'<img src="{link}" alt="">' if file.suffix == ".png" else "report"
                    page.append(f'<figure><a href="{link}">{shown}</a><figcaption>{title}</figcaption></figure>')
                else:
                    others.append(f"{title}: {link}")
            if others:
                page.append(f'<p class="files">{"<br>".join(others)}</p>')
            page.append("</section>")
        (self.folder / "index.html").write_text("\n".join(page) + "\n", encoding="utf-8")


class Golden:
    """What the fixture `golden` is."""

    def __init__(self, config: Any, node: Any, verdicts: _Verdicts) -> None:
        chosen = config.getoption("--golden-dir")
        self.folder = pathlib.Path(chosen) if chosen else pathlib.Path(str(node.path)).parent / "goldens"
        self._approve: bool = config.getoption("--golden-approve")
        self._widen: bool = config.getoption("--golden-widen")
        self._anyway: bool = config.getoption("--golden-anyway")
        self._test: str = node.nodeid
        self._verdicts = verdicts

    def check(self, picture: Any, name: str, *, tier: str = "exact", mask: Any = None) -> None:
        """Fails unless the picture (an array of bytes, a figure, PNG bytes) is as accepted in NAME.png."""
        data = png_bytes(picture)
        golden = self._file(name, ".png")
        frame, difference = self._result(name, ".frame.png"), self._result(name, ".difference.png")
        for old in (frame, difference):
            old.unlink(missing_ok=True)
        judged = compare(data, golden, tier=tier, mask=mask, difference=difference) if golden.exists() else None
        if judged is None or not judged.ok:
            frame.write_bytes(data)
        files = [("drawn", frame), ("accepted", golden), ("difference", difference)]
        self._conclude(name, judged, self._approve, lambda: _accept(frame, golden), files)

    def session(self, log: Any, cell: Any = None, name: str | None = None, *, pictures: bool = True,
                **more: Any) -> None:
        """Fails unless the recording did the same as the accepted NAME.mcap (default: the log's own name).

        Sessions accepted beside it by `pytest --golden-widen`, NAME+2.mcap ..., are a band: what lies
        between them is the same. What another program recorded (a bag, a capture, a table) is accepted as
        it is, NAME.csv. Without `pictures` behaviour alone is judged, and nothing is drawn.

        Other keywords are those of `rocinante.goldens.compare_sessions`.
        """
        new = pathlib.Path(os.fspath(log))
        name = name or new.stem
        ending = "" if new.is_dir() else new.suffix or ".mcap"
        golden = self._file(name, ending)
        report = self._result(name, ".report")
        shutil.rmtree(report, ignore_errors=True)
        accepted = _accepted_sessions(golden, ending)
        judged = compare_sessions(accepted, log, cell, pictures=pictures, report=report,
                                  **more) if accepted else None

        def accept() -> str:
            # A log of which nothing can be judged would accept everything.
            try:
                alone = compare_sessions(new, new, cell, pictures=False, **more)
            except Error as fault:
                return str(fault)
            if not alone.ok:
                return str(alone)
            if objection := "" if self._anyway else _objection(new, cell, more):
                return f"{objection} (pytest --golden-anyway accepts it all the same)"
            if self._widen:
                number = max([1, *(_number_of(each) for each in accepted)]) + 1
                _accept(new, golden.with_name(f"{_stem(golden, ending)}+{number}{ending}")
                        if accepted else golden)
            else:
                for old in accepted:
                    shutil.rmtree(old) if old.is_dir() else old.unlink()
                _accept(new, golden)
            return ""

        self._conclude(name, judged, self._approve or self._widen, accept,
                       [("report", report / "index.html"), ("new", new),
                        *(("accepted", each) for each in accepted or [golden])])

    def _file(self, name: str, ending: str) -> pathlib.Path:
        if not re.fullmatch(r"[\w][\w.\- /]*", name) or ".." in name:
            raise ValueError(f"not a name of a golden: {name!r}")
        return self.folder / (name + ending)

    def _result(self, name: str, ending: str) -> pathlib.Path:
        path = self._verdicts.folder / (name + ending)
        path.parent.mkdir(parents=True, exist_ok=True)
        return path

    def _conclude(self, name: str, judged: Comparison | None, approves: bool, accept: Callable[[], str],
                  files: list[tuple[str, pathlib.Path]]) -> None:
        """`accept` takes the new file for the accepted one, and says why it cannot."""
        ok = judged is not None and judged.ok
        lines = [f"there is no accepted file yet: {dict(files)['accepted']}"]
        if judged is not None:
            first, *rest = judged.reasons
            lines = [f"{judged.verdict}: {first}", *rest]
        accepted = False
        remedy = "pytest --golden-approve accepts it"
        if not ok and approves:
            refusal = "refused where CI is set" if os.environ.get("CI") else accept()
            accepted = not refusal
            remedy = f"not accepted: {refusal}"
            lines[0] = f"accepted now ({lines[0]})" if accepted else f"{lines[0]}; {remedy}"
        self._verdicts.sections.append(_Section(f"{self._test}: {name}", ok or accepted, lines, [
            (title, file) for title, file in files if file.exists()]))
        if not ok and not accepted:
            first, *rest = lines
            if len(rest) > MOST_LINES:
                rest[MOST_LINES:] = [f"... and {len(rest) - MOST_LINES} more"]
            page = os.path.relpath(self._verdicts.folder / "index.html")
            pytest.fail("\n  ".join([f"golden {name}: {first}", *rest, f"{page}; {remedy}"]), pytrace=False)


#: keywords of a session that say where models are
_SEARCHES = ("search", "package", "search_env")


def _objection(new: pathlib.Path, cell: Any, more: Mapping[str, Any]) -> str:
    """What `golden approve --run` refuses, too: errors that `check` finds, but for those of pictures."""
    searches = {name: more[name] for name in _SEARCHES if name in more}
    try:
        findings = check(new, **searches) if cell is None else check(cell, new, **searches)
    except Error as fault:
        return str(fault)
    errors = [each for each in findings if each.severity == "error" and not each.is_of_pictures_only]
    if not errors:
        return ""
    others = f" and {len(errors) - 1} more" if len(errors) > 1 else ""
    return f"{errors[0].text} [{errors[0].rule}]{others}"


def _stem(golden: pathlib.Path, ending: str) -> str:
    return golden.name[:len(golden.name) - len(ending)]


def _number_of(accepted: pathlib.Path) -> int:
    """2 of NAME+2.mcap."""
    found = re.search(r"\+(\d+)(\.\w+)?$", accepted.name)
    return int(found[1]) if found else 1


def _accepted_sessions(golden: pathlib.Path, ending: str) -> list[pathlib.Path]:
    """NAME.mcap, then those accepted beside it, NAME+2.mcap ...: no name of a golden has a plus."""
    if not golden.parent.is_dir():
        return []
    pattern = re.escape(_stem(golden, ending)) + r"(\+\d+)?" + re.escape(ending)
    return sorted((each for each in golden.parent.iterdir() if re.fullmatch(pattern, each.name)), key=_number_of)


def _accept(new: pathlib.Path, golden: pathlib.Path) -> str:
    golden.parent.mkdir(parents=True, exist_ok=True)
    if new.is_dir():
        shutil.copytree(new, golden)
    else:
        shutil.copyfile(new, golden)
    return ""


def pytest_configure(config: Any) -> None:
    config._rocinante_verdicts = _Verdicts(pathlib.Path(config.getoption("--golden-results")).absolute())


def pytest_sessionfinish(session: Any) -> None:
    if session.config._rocinante_verdicts.sections:
        session.config._rocinante_verdicts.write()


@pytest.fixture
def golden(request: Any) -> Golden:
    """Pictures and sessions against accepted ones (rocinante.pytest_plugin)."""
    return Golden(request.config, request.node, request.config._rocinante_verdicts)
