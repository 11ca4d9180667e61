import pathlib

import pytest

DEMO = pathlib.Path(__file__).resolve().parents[2] / "examples/demo"


@pytest.fixture
def demo():
    """The demo cell and its session."""
    return DEMO / "demo.cell.toml", DEMO / "session.mcap"
