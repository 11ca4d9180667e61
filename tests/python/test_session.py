import subprocess

import numpy as np
import pytest

import rocinante
from foreign import FORMS, capture, foreign
from rocinante._programs import run_json


def test_a_session_tells_what_it_holds(demo):
    cell, log = demo
    session = rocinante.Session(log, cell)
    assert session.duration == 19.990008348
    assert session.sources == ["arm", "gantry", "planner"]
    assert [(event.text, event.source) for event in session.events] == [("picked", "planner"), ("placed", "planner")]
    assert session.events[0].time == pytest.approx(4.603931882, abs=1e-9)
    assert "3064 messages" in repr(session)


def test_joints_are_columns_by_name(demo):
    cell, log = demo
    arm = rocinante.Session(log, cell).joints("arm", every=0.5, start=1, end=3)
    assert arm.time.tolist() == [1.0, 1.5, 2.0, 2.5]
    assert arm.values.shape == (4, 6)
    assert np.array_equal(arm["joint3"], arm.values[:, arm.names.index("joint3")])
    state = rocinante.Session(log, cell).state(2.5)
    assert arm.values[-1].tolist() == list(state.devices["arm"].joints)
    with pytest.raises(KeyError, match="no joint wrong"):
        arm["wrong"]


@pytest.mark.parametrize("form", FORMS)
def test_what_another_program_recorded_is_a_session(tmp_path, form):
    arm, log = foreign(tmp_path, form)
    session = rocinante.Session(log, arm)
    assert session.joints("arm")["shoulder"].tolist() == [i / 100 for i in range(100)]
    assert session.state(2).devices["arm"].named_joints == {"shoulder": 0.4}


@pytest.mark.parametrize("form", FORMS)
def test_what_another_program_recorded_is_compared(tmp_path, form):
    arm, log = foreign(tmp_path, form)
    _, other = foreign(tmp_path, form, "other", 0.5)
    assert rocinante.compare_sessions(log, log, arm, pictures=False).ok
    judged = rocinante.compare_sessions(log, other, arm, pictures=False)
    assert not judged.ok and any(reason.startswith("arm/shoulder: ") for reason in judged.reasons)


def test_several_accepted_sessions_are_a_band(tmp_path):
    arm, first = foreign(tmp_path, "csv", "first")
    _, second = foreign(tmp_path, "csv", "second", 0.1)
    _, between = foreign(tmp_path, "csv", "between", 0.05)
    assert not rocinante.compare_sessions(first, between, arm, pictures=False).ok
    assert rocinante.compare_sessions([first, second], between, arm, pictures=False).ok
    # The keywords that the docstring names.
    assert rocinante.compare_sessions(first, between, arm, pictures=False, joint_deg=5, position_mm=90,
                                      turn_deg=5, event_ms=50).ok


def test_a_verdict_is_short_and_its_text_has_the_reasons(tmp_path):
    arm, first = foreign(tmp_path, "csv", "first")
    _, other = foreign(tmp_path, "csv", "other", 0.05)
    judged = rocinante.compare_sessions(first, other, arm, pictures=False)
    assert repr(judged) == "Comparison(ok=False, verdict='different')"
    assert str(judged).startswith("different: arm/") and "accepted" in str(judged)
    same = rocinante.compare_sessions(first, first, arm, pictures=False)
    assert str(same).startswith("same: ") and "within the limits" in str(same)


def test_all_events_are_there(tmp_path):
    def lines(i):
        return "".join(f'event "step {i * 100 + j}"\n' for j in range(100))
    traffic, log = tmp_path / "traffic.pcap", tmp_path / "session.mcap"
    capture(traffic, [(i, f"RK1 me@a {i} -\n{lines(i)}") for i in range(15)])
    subprocess.run([rocinante.program(), "log", "import", traffic, "-o", log], check=True, capture_output=True)
    assert [event.text for event in rocinante.Session(log).events] == [f"step {i}" for i in range(1500)]


def test_a_device_without_values_is_named(demo):
    cell, log = demo
    with pytest.raises(rocinante.Error, match="no chosen device has joints or a pose; did you mean `arm`"):
        rocinante.Session(log, cell).joints("arms")
    with pytest.raises(rocinante.Error, match="there are arm, canister, gantry"):
        rocinante.Session(log, cell).poses("wrong")
    with pytest.raises(KeyError, match="no joint values of a device canister; there are those of arm, gantry"):
        rocinante.Session(log, cell).joints("canister")


def test_poses_are_positions_and_quaternions(demo):
    cell, log = demo
    poses = rocinante.Session(log, cell).poses("canister", every=1, start=1)
    assert poses.position.shape == (len(poses.time), 3) and poses.orientation.shape == (len(poses.time), 4)
    assert poses.position[0].tolist() == [-2.4, -1.0, 0.25]
    assert np.allclose(np.linalg.norm(poses.orientation, axis=1), 1)
    # The gantry lifts and carries it.
    assert poses.position[:, 2].max() > 1.5


def test_a_link_is_where_the_forward_kinematics_have_it(demo):
    cell, log = demo
    session = rocinante.Session(log, cell)
    hand = session.link("arm/tip", every=1, start=1, end=4)
    assert hand.time.tolist() == [1.0, 2.0, 3.0]
    fk = run_json("model", "fk", cell, "--log", log, "--at=3s", "--json")["arm/tip"]
    assert hand.position[-1].tolist() == fk["xyz"]
    assert hand.orientation[-1].tolist() == fk["quaternion"]
    # From itself it is always the same.
    own = session.link("arm/tip", "arm/tip", every=1, start=1, end=4)
    assert np.allclose(own.position, 0, atol=1e-12) and np.allclose(own.orientation, [0, 0, 0, 1], atol=1e-12)
    with pytest.raises(rocinante.Error, match="`arm` has no link `hnad`"):
        session.link("arm/hnad")


def test_what_is_derived_is_a_column(demo):
    cell, log = demo
    session = rocinante.Session(log, cell)
    apart = "arm/tip:x - arm/tip:y"
    table = session.table("arm", links=["arm/tip"], derive=["d/dt arm/tip:z", apart])
    assert np.allclose(table[apart], table["arm/tip:x"] - table["arm/tip:y"], equal_nan=True)
    assert np.isfinite(table["d/dt arm/tip:z"]).any()
    with pytest.raises(rocinante.Error, match="SECONDS is a number from 1e-9 to 3600, not `nan`"):
        session.table(derive=["mean nan arm/tip:z"])


def test_names_that_look_like_patterns_are_names(tmp_path, demo):
    log = tmp_path / "odd.mcap"
    with rocinante.record(log, "127.0.0.1:0") as recorder:
        port = int(recorder.endpoints[0].rsplit(":", 1)[1])
        with rocinante.Source("odd", ("127.0.0.1", port)) as source:
            source.joints("a*", [1, 2])
            source.joints("ab", [3, 4])
    with pytest.warns(rocinante.RocinanteWarning, match="no model names them"):
        assert rocinante.Session(log).joints("a*").values[-1].tolist() == [1, 2]


def test_what_is_no_log_is_one_sentence(tmp_path):
    with pytest.raises(rocinante.Error, match="nowhere.mcap"):
        rocinante.Session(tmp_path / "nowhere.mcap")


def test_damage_is_a_warning(demo, tmp_path):
    cell, log = demo
    data = bytearray(log.read_bytes())
    for i in range(60000, 60040):
        data[i] ^= 0xFF
    broken = tmp_path / "broken.mcap"
    broken.write_bytes(data)
    with pytest.warns(rocinante.DamageWarning):
        rocinante.Session(broken, cell).joints("arm")


def test_without_the_program_the_remedy_is_named(monkeypatch):
    monkeypatch.delenv("ROCINANTE", raising=False)
    monkeypatch.setenv("PATH", "/nonexistent")
    with pytest.raises(rocinante.Error, match="set ROCINANTE"):
        rocinante.program()


@pytest.mark.parametrize("content", [None, "no program"])
def test_what_is_no_program_is_named(monkeypatch, tmp_path, content):
    path = tmp_path / "rocinante"
    if content:
        path.write_text(content)
    monkeypatch.setenv("ROCINANTE", str(path))
    with pytest.raises(rocinante.Error, match=f"ROCINANTE is {path}, which is not a program"):
        rocinante.Session("session.mcap")
    with pytest.raises(rocinante.Error, match="which is not a program"):
        with rocinante.record(tmp_path / "session.mcap", "127.0.0.1:0"):
            pass
    path.write_text("no program")
    path.chmod(0o755)
    with pytest.raises(rocinante.Error, match="cannot be run"):
        rocinante.Session("session.mcap")


def test_findings_are_a_list_with_a_verdict(demo):
    cell, log = demo
    assert rocinante.check(cell, log).ok
    findings = rocinante.check(cell.parent / "arm.urdf", log)
    assert not findings.ok and findings.verdict == "incompatible"
    assert {finding.rule for finding in findings} == {"packet.unknown-device"}
    assert "canister at 0.003 s" in str(findings)
    assert rocinante.check(cell.parent / "arm.urdf", log, rules={"packet.unknown-device": "note"}).ok
    with pytest.raises(rocinante.Error):
        rocinante.check(cell, log, rules={"no.such-rule": "off"})
