"""A fixture `golden` for pytest: pictures and sessions against accepted ones.

    def test_gauge(golden):
        golden.check(draw_gauge(), "gauge")

    def test_pick(golden):
        golden.session("out/pick.mcap", "cell.toml")

Accepted files lie in the folder `goldens` beside the test. `pytest --golden-approve` accepts what would
fail; it is refused where CI is set. Every run leaves one page of all verdicts,
`golden-results/index.html`.
"""
from __future__ import annotations

import html
import os
import pathlib
import re
import shutil
from typing import Any

import pytest

from .goldens import Comparison, compare, compare_sessions, png_bytes

_PAGE = """<!doctype html><meta charset="utf-8"><title>Goldens</title>
<style>body{font:15px sans-serif;margin:2em auto;max-width:72em;color:#222;background:#fff}
figure{display:inline-block;margin:0 1em 1em 0}img{max-width:22em;border:1px solid #ccc;image-rendering:pixelated}
section{border-top:1px solid #ccc;padding:.6em 0}.failed h2{color:#b00020}h2{font-size:1.1em}</style>
"""


def pytest_addoption(parser: Any) -> None:
    group = parser.getgroup("rocinante")
    group.addoption("--golden-approve", action="store_true",
                    help="accept pictures and sessions that would fail (refused where CI is set)")
    group.addoption("--golden-dir", help="folder of accepted files (default: goldens beside each test)")
    group.addoption("--golden-results", default="golden-results",
                    help="folder of failing frames and of the page of all verdicts")


class _Verdicts:
    """All verdicts of a run, and their page."""

    def __init__(self, folder: pathlib.Path) -> None:
        self.folder = folder
        self.sections: list[tuple[str, bool, str, list[tuple[str, str]]]] = []

    def add(self, name: str, ok: bool, text: str, files: list[tuple[str, str]]) -> None:
        self.sections.append((name, ok, text, files))

    def write(self) -> None:
        self.folder.mkdir(parents=True, exist_ok=True)
        failed = sum(not ok for _, ok, _, _ in self.sections)
        page = [_PAGE, f"<h1>{len(self.sections)} verdicts, {failed} failed</h1>"]
        for name, ok, text, files in sorted(self.sections, key=lambda each: each[1]):
            page.append(f'<section class="{"passed" if ok else "failed"}"><h2>{html.escape(name)}</h2>'
                        f"<p>{html.escape(text)}</p>")
            for title, file in files:
                link = html.escape(file, quote=True)
                shown = f'<img src="{link}" alt="">' if file.endswith(".png") else "report"
                page.append(f'<figure><a href="{link}">{shown}</a><figcaption>{title}</figcaption></figure>')
            page.append("</section>")
        (self.folder / "index.html").write_text("\n".join(page) + "\n", encoding="utf-8")


class Golden:
    """What the fixture `golden` is."""

    def __init__(self, config: Any, node: Any, verdicts: _Verdicts) -> None:
        chosen = config.getoption("--golden-dir")
        self.folder = pathlib.Path(chosen) if chosen else pathlib.Path(str(node.path)).parent / "goldens"
        self._approve: bool = config.getoption("--golden-approve")
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
        self._conclude(name, golden, frame, judged, _figures(judged), files)

    def session(self, log: Any, cell: Any = None, name: str | None = None, **more: Any) -> None:
        """Fails unless the recording did the same as the accepted NAME.mcap (default: the log's own name).

        What another program recorded (a bag, a capture, a table) is accepted as it is, NAME.csv.

        Other keywords are those of `rocinante.goldens.compare_sessions`.
        """
        name = name or pathlib.Path(os.fspath(log)).stem
        golden = self._file(name, pathlib.Path(os.fspath(log)).suffix or ".mcap")
        report = self._result(name, ".report")
        shutil.rmtree(report, ignore_errors=True)
        judged = compare_sessions(golden, log, cell, report=report, **more) if golden.exists() else None
        self._conclude(name, golden, pathlib.Path(os.fspath(log)), judged, "",
                       [("report", report / "index.html")])

    def _file(self, name: str, ending: str) -> pathlib.Path:
        if not re.fullmatch(r"[\w][\w.\- /]*", name) or ".." in name:
            raise ValueError(f"not a name of a golden: {name!r}")
        return self.folder / (name + ending)

    def _result(self, name: str, ending: str) -> pathlib.Path:
        path = self._verdicts.folder / (name + ending)
        path.parent.mkdir(parents=True, exist_ok=True)
        return path

    def _conclude(self, name: str, golden: pathlib.Path, new: pathlib.Path, judged: Comparison | None,
                  figures: str, files: list[tuple[str, pathlib.Path]]) -> None:
        ok = judged is not None and judged.ok
        text = "there is no accepted file yet" if judged is None else judged.verdict + figures
        accepted = False
        if not ok and self._approve:
            if os.environ.get("CI"):
                text += "; --golden-approve is refused where CI is set"
            else:
                golden.parent.mkdir(parents=True, exist_ok=True)
                shutil.copyfile(new, golden)
                accepted, text = True, f"accepted now ({text})"
        self._verdicts.add(f"{self._test}: {name}", ok or accepted, text, [
            (title, os.path.relpath(file, self._verdicts.folder)) for title, file in files if file.exists()])
        if not ok and not accepted:
            pytest.fail(f"golden {name}: {text}\n  accepted: {golden}\n  new:      {new}\n"
                        f"  page:     {self._verdicts.folder / 'index.html'}\n"
                        "  pytest --golden-approve accepts it", pytrace=False)


def _figures(judged: Comparison | None) -> str:
    if judged is None:
        return ""
    return f": {judged.document['rule']} ({judged.document['differing']} differing pixels, at most {judged.document['max']} of 255)"


def pytest_configure(config: Any) -> None:
    config._rocinante_verdicts = _Verdicts(pathlib.Path(config.getoption("--golden-results")).absolute())


@pytest.hookimpl(trylast=True)
def pytest_sessionfinish(session: Any) -> None:
    if session.config._rocinante_verdicts.sections:
        session.config._rocinante_verdicts.write()


@pytest.fixture
def golden(request: Any) -> Golden:
    """Pictures and sessions against accepted ones (rocinante.pytest_plugin)."""
    return Golden(request.config, request.node, request.config._rocinante_verdicts)
