import doctest
import re

import rocinante


def test_the_examples_of_the_package_are_true(demo, monkeypatch):
    monkeypatch.chdir(demo[0].parent)
    results = doctest.testmod(rocinante)
    assert results.attempted >= 7 and results.failed == 0


def test_everything_public_has_a_docstring():
    for name in rocinante.__all__:
        thing = getattr(rocinante, name)
        assert thing.__doc__, name
        for each, method in vars(thing).items() if isinstance(thing, type) else ():
            assert each.startswith("_") or not callable(method) or method.__doc__, f"{name}.{each}"


def test_the_examples_of_the_page_run(demo, monkeypatch, capsys):
    page = (demo[0].parents[2] / "docs/python.md").read_text()
    blocks = re.findall(r"^```python\n(.*?)^```", page, re.DOTALL | re.MULTILINE)
    assert len(blocks) == 4
    monkeypatch.chdir(demo[0].parent)
    names = {}
    for block in blocks:
        exec(compile(block, "docs/python.md", "exec"), names)
    said = capsys.readouterr().out
    assert "(2009, 6)" in said and "planner: picked" in said and "3 (100, 160, 4)" in said
