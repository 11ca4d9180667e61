"""Runs the programs of Rocinante. Exit codes: 0 done; 1 the answer is no, or something was not kept;
2 could not run."""
from __future__ import annotations

import json
import os
import shutil
import subprocess
import warnings
from typing import Any, Iterable, Mapping, Union

PathLike = Union[str, "os.PathLike[str]"]
Time = Union[float, int, str]


class Error(Exception):
    """A program could not do what was asked; its message is the program's own sentence."""


class RocinanteWarning(UserWarning):
    """What a program said beside its answer."""


class DamageWarning(RocinanteWarning):
    """The answer leaves something out, because a log is damaged or something was not kept."""


def program() -> str:
    """The path of the program `rocinante`: $ROCINANTE, or the one on PATH."""
    chosen = os.environ.get("ROCINANTE")
    found = shutil.which(chosen or "rocinante")
    if found:
        return found
    if chosen:
        raise Error(f"ROCINANTE is {chosen}, which is not a program: set it to the path of rocinante")
    raise Error("there is no program rocinante on PATH: install it, or set ROCINANTE to its path")


def sentences(text: bytes) -> str:
    """What a program said on standard error, without its name before each line."""
    lines = text.decode(errors="replace").strip().splitlines()
    return "\n".join(line.split(": ", 1)[1] if line.startswith("rocinante") and ": " in line else line
                     for line in lines)


def run(*words: Any, verdicts: tuple[int, ...] = ()) -> bytes:
    """Runs `rocinante WORDS...` and returns its standard output.

    Exit codes in `verdicts` are answers, as long as something was printed. Of the others 0 may come
    with a RocinanteWarning, 1 with a DamageWarning, and the rest are an Error.
    """
    command = [program(), *(os.fspath(word) for word in words)]
    try:
        done = subprocess.run(command, stdin=subprocess.DEVNULL, capture_output=True, check=False)
    except OSError as fault:
        raise Error(f"{command[0]} cannot be run: {fault.strerror}") from None
    if done.returncode in verdicts and done.stdout:
        return done.stdout
    said = sentences(done.stderr)
    if done.returncode not in (0, 1) or verdicts:
        raise Error(said or f"`{' '.join(command)}` ended with {done.returncode}")
    if done.returncode == 1:
        warnings.warn(said or "something was not kept", DamageWarning, stacklevel=3)
    elif said:
        warnings.warn(said, RocinanteWarning, stacklevel=3)
    return done.stdout


def run_json(*words: Any, verdicts: tuple[int, ...] = ()) -> dict[str, Any]:
    """What `rocinante WORDS...` prints, which is one JSON document."""
    text = run(*words, verdicts=verdicts)
    try:
        document: dict[str, Any] = json.loads(text)
    except ValueError as fault:
        raise Error(f"`rocinante {words[0]}` printed no JSON: {fault}") from fault
    return document


def time_word(time: Time) -> str:
    """A time as the programs read it: numbers are seconds from the session's origin."""
    return time if isinstance(time, str) else f"{time:.9f}s"


def options(named: Mapping[str, Any]) -> list[str]:
    """Keyword arguments as options: hide=["a", "b"] is --hide=a --hide=b, shadows=True is --shadows."""
    words: list[str] = []
    for name, value in named.items():
        option = "--" + name.rstrip("_").replace("_", "-")
        if value is None or value is False:
            continue
        if value is True:
            words.append(option)
            continue
        values: Iterable[Any] = value if isinstance(value, (list, tuple)) else [value]
        words.extend(f"{option}={os.fspath(each) if isinstance(each, os.PathLike) else each}"
                     for each in values)
    return words
