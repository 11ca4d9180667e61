import numpy as np
import pytest

import rocinante


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


def test_what_another_program_recorded_is_a_session(tmp_path):
    arm = tmp_path / "arm.urdf"
    arm.write_text("""<robot name="arm"><link name="base"/><link name="upper"/>
        <joint name="shoulder" type="revolute"><parent link="base"/><child link="upper"/>
        <limit lower="-2" upper="2" effort="1" velocity="9"/></joint></robot>""")
    table = tmp_path / "swing.csv"
    table.write_text("t,shoulder\n" + "".join(f"{i / 20},{i / 100}\n" for i in range(100)))
    session = rocinante.Session(table, arm)
    assert session.joints("arm")["shoulder"].tolist() == [i / 100 for i in range(100)]
    assert session.state(2).devices["arm"].named_joints == {"shoulder": 0.4}


def test_a_device_without_values_is_named(demo):
    cell, log = demo
    with pytest.raises(rocinante.Error, match="no chosen device has joints or a pose"):
        rocinante.Session(log, cell).joints("arms")
    with pytest.raises(KeyError, match="no joint values of a device canister"):
        rocinante.Session(log, cell).joints("canister")


def test_poses_are_positions_and_quaternions(demo):
    cell, log = demo
    poses = rocinante.Session(log, cell).poses("canister", every=1, start=1)
    assert poses.position.shape == (len(poses.time), 3) and poses.orientation.shape == (len(poses.time), 4)
    assert poses.position[0].tolist() == [-2.4, -1.0, 0.25]
    assert np.allclose(np.linalg.norm(poses.orientation, axis=1), 1)
    # The gantry lifts and carries it.
    assert poses.position[:, 2].max() > 1.5


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
