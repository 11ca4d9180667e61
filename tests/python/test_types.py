import pathlib
import shutil
import subprocess

import pytest

import rocinante


def test_the_types_of_the_package_are_strict(tmp_path):
    mypy = shutil.which("mypy")
    if not mypy:
        pytest.skip("there is no mypy")
    package = pathlib.Path(rocinante.__file__).parent
    done = subprocess.run([mypy, "--strict", "--cache-dir", tmp_path, package], capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr
