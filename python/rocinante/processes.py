"""Recorders and players as context managers."""
from __future__ import annotations

import json
import os
import re
import signal
import socket
import subprocess
import tempfile
import threading
from typing import Any, Mapping, Sequence

from ._programs import Error, PathLike, Time, options, program, sentences, time_word


class _Process:
    """A program that runs until a signal or a command ends it, and then prints a JSON document."""

    def __init__(self, command: list[str], ready: str) -> None:
        self._command = command
        self._said: list[bytes] = []
        self._ready = threading.Event()
        self._pattern = re.compile(ready.encode())
        self.report: dict[str, Any] = {}  #: what the program prints at its end

    def _start(self) -> None:
        command = [program(), *self._command]
        try:
            self._process = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                                             stderr=subprocess.PIPE)
        except OSError as fault:
            raise Error(f"{command[0]} cannot be run: {fault.strerror}") from None
        self._printed: list[bytes] = []
        self._readers = [threading.Thread(target=self._read_said, daemon=True),
                         threading.Thread(target=self._read_printed, daemon=True)]
        for reader in self._readers:
            reader.start()
        self._ready.wait(timeout=30)
        if not self._ready.is_set() or not self._is_ready():
            self._process.kill()
            self._finish()
            raise Error(sentences(b"".join(self._said)) or f"rocinante {self._command[0]} did not begin")

    def _is_ready(self) -> bool:
        return any(self._pattern.search(line) for line in list(self._said))

    def _read_said(self) -> None:
        for line in self._process.stderr:  # type: ignore[union-attr]
            self._said.append(line)
            if self._pattern.search(line):
                self._ready.set()
        self._ready.set()  # it ended

    def _read_printed(self) -> None:
        self._printed.append(self._process.stdout.read())  # type: ignore[union-attr]

    def _finish(self) -> None:
        self._process.wait()
        for reader in self._readers:
            reader.join()
        if self._process.returncode not in (0, 1):
            return
        text = b"".join(self._printed)
        self.report = json.loads(text) if text.strip() else {}

    def _end(self, stop: bool) -> None:
        """Waits for the end, which is asked for by a signal when `stop`."""
        if stop and self._process.poll() is None:
            self._process.send_signal(signal.SIGINT)
        self._finish()
        if self._process.returncode not in (0, 1):
            raise Error(sentences(b"".join(self._said)) or
                        f"rocinante {self._command[0]} ended with {self._process.returncode}")

    @property
    def said(self) -> str:
        """What the program has said on standard error so far."""
        return sentences(b"".join(list(self._said)))


class Recorder(_Process):
    """A running `rocinante record`; see `record`."""

    def __init__(self, log: PathLike, words: list[str]) -> None:
        super().__init__(["record", *words, "-o", os.fspath(log), "--json"], r"^recording ")
        self.log = os.fspath(log)

    @property
    def endpoints(self) -> list[str]:
        """Where it listens, with the ports that port 0 became."""
        found = re.search(rb"^recording (.*) to ", b"".join(list(self._said)), re.MULTILINE)
        return re.findall(r"udp://[^\s,]+", found.group(1).decode()) if found else []

    def __enter__(self) -> "Recorder":
        self._start()
        return self

    def __exit__(self, kind: Any, fault: Any, trace: Any) -> None:
        self._end(stop=True)


def record(log: PathLike, *endpoints: str, **more: Any) -> Recorder:
    """Records what arrives while the block runs; afterwards `.report` says what, and what was lost.

        with rocinante.record("session.mcap", "127.0.0.1:19960") as recorder:
            ...
        assert recorder.report["packets"] > 0

    Without endpoints it listens to the local multicast group. Other keywords are options of
    `rocinante record`: cell="demo.cell.toml", force=True.
    """
    return Recorder(log, [*endpoints, *options(more)])


class Player(_Process):
    """A running `rocinante play`, under control; see `play`. Each method returns the player's status:
    `t` in seconds from the origin, `state`, `speed` and `sent`."""

    def __init__(self, logs: Sequence[PathLike], words: list[str]) -> None:
        self._folder = tempfile.TemporaryDirectory()
        self._control = os.path.join(self._folder.name, "control")
        super().__init__(["play", *(os.fspath(log) for log in logs), *words, "--json",
                          "--control", f"unix:{self._control}"], r"^listening for commands")

    def __enter__(self) -> "Player":
        try:
            self._start()
            self._socket = socket.socket(socket.AF_UNIX, socket.SOCK_STREAM)
            self._socket.connect(self._control)
            self._answers = self._socket.makefile("rb")
        except OSError:  # it ended before it played
            self._finish()
            self._folder.cleanup()
            raise Error(self.said) from None
        except BaseException:
            self._folder.cleanup()
            raise
        return self

    def __exit__(self, kind: Any, fault: Any, trace: Any) -> None:
        try:
            if self._process.poll() is None:
                self.command("quit")
        except (Error, OSError):
            pass  # it is ending already
        self._answers.close()
        self._socket.close()
        try:
            self._end(stop=True)
        finally:
            self._folder.cleanup()

    def command(self, line: str) -> Mapping[str, Any]:
        """Sends one line of the control protocol and returns its answer."""
        self._socket.sendall(line.encode() + b"\n")
        answer = self._answers.readline().decode().strip()
        if not answer.startswith("ok"):
            raise Error(answer.partition(" ")[2] or "the player has ended")
        fields: dict[str, Any] = dict(word.split("=", 1) for word in answer.split()[1:] if "=" in word)
        for name in ("t", "speed"):
            if name in fields and fields[name] != "asap":
                fields[name] = float(fields[name])
        if "sent" in fields:
            fields["sent"] = int(fields["sent"])
        return fields

    def status(self) -> Mapping[str, Any]:
        """Where it is."""
        return self.command("status")

    def seek(self, time: Time) -> Mapping[str, Any]:
        """Jumps to a session time, restating the state there."""
        return self.command(f"seek {time_word(time)}")

    def pause(self) -> Mapping[str, Any]:
        """Stops where it is."""
        return self.command("pause")

    def resume(self) -> Mapping[str, Any]:
        """Plays on; from the start when it is at the end."""
        return self.command("play")

    def step(self, messages: int = 1) -> Mapping[str, Any]:
        """Pauses and sends the next messages at once."""
        return self.command(f"step {messages}")

    def set_speed(self, speed: float) -> Mapping[str, Any]:
        """Log seconds per second, 0.01 to 1000."""
        return self.command(f"speed {speed:g}")

    def wait(self, poll: float = 0.02) -> Mapping[str, Any]:
        """Waits until the end of the log is reached."""
        pause = threading.Event()
        while (now := self.status())["state"] == "playing":
            pause.wait(poll)
        return now


def play(*logs: PathLike, **more: Any) -> Player:
    """Re-emits logs as UDP while the block runs; afterwards `.report` says what, and how late.

        with rocinante.play("session.mcap", to="127.0.0.1:19960", start_paused=True) as player:
            player.seek(12.5)
            player.resume()
            player.wait()

    Keywords are options of `rocinante play`: speed=10, from_="2s", loop=0.
    """
    return Player(logs, options(more))
