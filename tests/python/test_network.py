"""Recorder, player and source, over loopback."""
import socket
import time

import pytest

import rocinante


def port_of(recorder):
    return int(recorder.endpoints[0].rsplit(":", 1)[1])


def test_what_is_played_is_recorded(demo, tmp_path):
    cell, log = demo
    copy = tmp_path / "copy.mcap"
    with rocinante.record(copy, "127.0.0.1:0") as recorder:
        with rocinante.play(log, to=f"127.0.0.1:{port_of(recorder)}", asap=True, restate="off") as player:
            assert player.wait()["state"] == "ended"
    assert player.report["sent"] == 3064
    assert recorder.report["packets"] == 3064
    assert rocinante.Session(copy).info["stream_sha256"] == player.report["stream_sha256"]


def test_a_player_is_driven(demo):
    with rocinante.play(demo[1], to="127.0.0.1:9", start_paused=True) as player:
        assert player.status()["state"] == "paused"
        assert player.seek(5)["t"] == pytest.approx(5, abs=0.05)
        before = player.status()["sent"]
        assert player.step(3)["sent"] == before + 3
        assert player.set_speed(2)["speed"] == 2
        with pytest.raises(rocinante.Error, match="unknown command jump"):
            player.command("jump")
        assert player.resume()["state"] == "playing"
        assert player.pause()["state"] == "paused"


def test_what_cannot_begin_says_why(tmp_path):
    with pytest.raises(rocinante.Error, match="nothing.mcap"):
        with rocinante.play(tmp_path / "nothing.mcap"):
            pass
    with pytest.raises(rocinante.Error):
        with rocinante.record(tmp_path / "a.mcap", "not-an-endpoint"):
            pass


def test_a_source_is_heard_whole(tmp_path):
    log = tmp_path / "sent.mcap"
    with rocinante.record(log, "127.0.0.1:0") as recorder:
        with rocinante.Source("cell one", ("127.0.0.1", port_of(recorder)), run="r1") as source:
            source.order("arm", ["shoulder", "elbow"])
            source.joints("arm", [0.5, -0.0])
            source.joints("grip", {"width": 0.0625})
            source.pose("tray", [1, 2, 0.1], parent=("arm", "tool 0"))
            source.color("arm/tool 0", "#ff8800")
            source.show("layer/walls", False)
            source.label("here", [0, 0, 1], 'a "quoted"\nword')
            source.line("way", [[0, 0, 0], [1, 0, 0.5]])
            source.event("picked")
            source.flush()
            source.remove("grip")
            source.erase("way")
            for q in (0.1, 0.2):
                source.joints("arm", [q, 1 / 3])
                source.flush()
    assert recorder.report["losses"]["kernel"] == 0
    session = rocinante.Session(log)
    assert session.sources == ["cell one"]
    assert [event.text for event in session.events] == ["picked"]
    state = session.state(session.duration)
    assert set(state.devices) == {"arm", "tray"}
    assert state.devices["arm"].named_joints == {"shoulder": 0.2, "elbow": 0.333333333}
    assert state.devices["tray"].parent == ("arm", "tool 0")
    assert [drawing["id"] for drawing in state.document["drawings"]] == ["here"]


def datagrams(receiver):
    receiver.setblocking(False)
    while True:
        try:
            yield receiver.recv(65536).decode()
        except BlockingIOError:
            return


def test_everything_is_said_again_in_parts_that_fit():
    receiver = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    receiver.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 1 << 20)
    receiver.bind(("127.0.0.1", 0))
    with rocinante.Source("many", receiver.getsockname(), restate=0.2) as source:
        for i in range(60):
            source.joints(f"device{i}", [i + 0.123456789] * 6)
        source.flush()
        first = list(datagrams(receiver))
        deadline = time.monotonic() + 30
        parts = {}
        while time.monotonic() < deadline and not any(len(p) == n for n, p in parts.values()):
            source.flush()
            for text in datagrams(receiver):
                assert " restated part=" in text.splitlines()[0], "what did not change is only restated"
                name, _, place = text.splitlines()[0].split("part=")[1].rpartition(":")
                i, n = map(int, place.split("/"))
                parts.setdefault(name, (n, {}))[1][i] = text
            time.sleep(0.005)
    assert all(len(text.encode()) <= 1200 for text in first)
    assert sum(text.count("joints device") for text in first) == 60
    whole = next(p for n, p in parts.values() if len(p) == n)
    assert sum(text.count("joints device") for text in whole.values()) == 60
    assert all(len(text.encode()) <= 1200 for text in whole.values())


@pytest.mark.parametrize("value, text", [
    (1e-12, "1e-12"), (0.1 + 0.2, "0.30000000000000004"), (-1.5e-7, "-1.5e-7"), (1e-5, "0.00001"), (7, "7"),
    (100000.0, "100000"), (2.0**53, "9.007199254740992e15"), (-0.0, "0"), (5e-324, "5e-324")])
def test_a_signal_arrives_to_the_last_bit(value, text):
    receiver = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    receiver.bind(("127.0.0.1", 0))
    with rocinante.Source("a", receiver.getsockname()) as source:
        source.signal("arm", "current", value, "A")
        source.flush()
    assert receiver.recv(65536).decode().splitlines()[1] == f"signal arm current {text} A"
    assert float(text) == value


@pytest.mark.parametrize("wrong", [
    lambda s: s.joints("arm", [float("nan")]), lambda s: s.signal("arm", "x", float("inf")), lambda s: s.joints("", [1]), lambda s: s.joints("arm", []),
    lambda s: s.color("arm", "red"), lambda s: s.event("\x01"), lambda s: s.pose("arm", [1, 2]),
    lambda s: s.joints("arm", [0.123456789] * 400)])
def test_what_a_packet_cannot_say_is_refused(wrong):
    with rocinante.Source("a", ("127.0.0.1", 9)) as source:
        with pytest.raises(ValueError):
            wrong(source)
