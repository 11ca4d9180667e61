import hashlib
import json
import os
import pathlib
import subprocess
import sys
import zlib

import numpy as np
import pytest

import rocinante
from foreign import FORMS, foreign
from rocinante.pictures import decode_png, encode_png

pytest_plugins = ["pytester"]


def frame_hash(cell, log, *words):
    """What rocinante render itself says of its pixels."""
    done = subprocess.run([rocinante.program(), "render", cell, log, *words, "--hash"], check=True,
                          capture_output=True, text=True)
    return done.stdout.split()


def test_a_frame_has_the_pixels_of_the_program(demo):
    cell, log = demo
    picture = rocinante.render(cell, log, at=3, size=(320, 200), shadows=True)
    assert picture.shape == (200, 320, 4) and picture.dtype == np.uint8
    assert hashlib.sha256(picture.tobytes()).hexdigest() in frame_hash(
        cell, log, "--at", "3", "--size", "320x200", "--shadows")
    assert picture._repr_png_()[:8] == b"\x89PNG\r\n\x1a\n"


def test_several_moments_are_several_frames(demo):
    cell, log = demo
    pictures = rocinante.render(cell, log, at=[1, 3.5], size=(96, 64))
    assert len(pictures) == 2 and not np.array_equal(*pictures)
    assert np.array_equal(pictures[1], rocinante.render(cell, log, at=3.5, size=(96, 64)))


def test_a_cell_at_rest(demo):
    assert rocinante.render(demo[0], size=(96, 64)).shape == (64, 96, 4)


def filtered(pixels, kind):
    """A PNG of these pixels whose rows all have one filter, straight from the specification."""
    height, width, channels = pixels.shape
    raw = bytearray()
    for y in range(height):
        raw.append(kind)
        for x in range(width):
            for c in range(channels):
                a = int(pixels[y, x - 1, c]) if x else 0
                b = int(pixels[y - 1, x, c]) if y else 0
                d = int(pixels[y - 1, x - 1, c]) if x and y else 0
                p = a + b - d
                paeth = min((abs(p - a), 0, a), (abs(p - b), 1, b), (abs(p - d), 2, d))[2]
                raw.append((int(pixels[y, x, c]) - [0, a, b, (a + b) // 2, paeth][kind]) & 255)
    plain = encode_png(pixels)
    at = plain.index(b"IDAT") - 4
    body = zlib.compress(bytes(raw))
    piece = b"IDAT" + body
    return plain[:at] + len(body).to_bytes(4, "big") + piece + zlib.crc32(piece).to_bytes(4, "big") + plain[-12:]


@pytest.mark.parametrize("kind", range(5))
def test_every_filter_of_a_row_is_read(kind):
    pixels = np.random.default_rng(kind).integers(0, 256, (13, 21, 4), np.uint8)
    assert np.array_equal(decode_png(filtered(pixels, kind)), pixels)


def test_cut_and_flipped_png_files_are_refused():
    data = encode_png(np.arange(5 * 7 * 4, dtype=np.uint8).reshape(5, 7, 4))
    for length in range(len(data) - 12):
        with pytest.raises(rocinante.Error):
            decode_png(data[:length])
    for i in range(16, len(data) - 12):
        flipped = bytearray(data)
        flipped[i] ^= 1
        try:
            decode_png(bytes(flipped))
        except rocinante.Error:
            continue
        pytest.fail(f"byte {i} was flipped and nobody noticed")


def test_pictures_are_compared(tmp_path):
    pixels = np.zeros((16, 16, 3), np.uint8)
    rocinante.Picture(pixels).save(tmp_path / "golden.png")
    assert rocinante.compare(pixels, tmp_path / "golden.png").ok
    pixels[3, 4] = 9
    judged = rocinante.compare(pixels, tmp_path / "golden.png", difference=tmp_path / "difference.png")
    assert not judged.ok and judged.document["differing"] == 1 and (tmp_path / "difference.png").exists()
    assert rocinante.compare(np.zeros((8, 8), np.uint8), tmp_path / "golden.png").verdict == "incomparable"
    with pytest.raises(TypeError):
        rocinante.compare(np.zeros((8, 8)), tmp_path / "golden.png")


OUTSIDE = '''
import numpy, pathlib, shutil
def test_gauge(golden):
    golden.check(numpy.full((16, 24, 4), {grey}, numpy.uint8), "gauge")
def test_pick(golden):
    golden.session({log!r}, {cell!r}, "pick", no_pictures=True)
'''


def outside(pytester, grey, log, cell, *words):
    pytester.makepyfile(test_outside=OUTSIDE.format(grey=grey, log=str(log), cell=str(cell)))
    return pytester.runpytest_subprocess("-p", "rocinante.pytest_plugin", *words)


def test_the_plugin_accepts_judges_and_leaves_a_page(pytester, demo, monkeypatch):
    monkeypatch.delenv("CI", raising=False)
    cell, log = demo
    first = outside(pytester, 128, log, cell)
    first.assert_outcomes(failed=2)
    first.stdout.fnmatch_lines(["*golden gauge: there is no accepted file yet*"])
    outside(pytester, 128, log, cell, "--golden-approve").assert_outcomes(passed=2)
    assert (pytester.path / "goldens/gauge.png").exists() and (pytester.path / "goldens/pick.mcap").exists()
    outside(pytester, 128, log, cell).assert_outcomes(passed=2)
    other = outside(pytester, 120, cell.parent / "motion.mcap", cell)
    other.assert_outcomes(failed=1, passed=1)
    other.stdout.fnmatch_lines(["*golden gauge: different*384 differing pixels, at most 8 of 255*",
                                "*golden-results/index.html; pytest --golden-approve accepts it"])
    page = (pytester.path / "golden-results/index.html").read_text()
    assert "2 verdicts, 1 failed" in page and "gauge.difference.png" in page
    for link in ("gauge.frame.png", "gauge.difference.png"):
        assert (pytester.path / "golden-results" / link).exists()


def test_ci_accepts_nothing(pytester, demo, monkeypatch):
    monkeypatch.setenv("CI", "true")
    cell, log = demo
    outside(pytester, 128, log, cell, "--golden-approve").assert_outcomes(failed=2)
    assert not (pytester.path / "goldens").exists()


def swing(pytester, log, arm, *words):
    pytester.makepyfile(test_outside=f"def test_swing(golden):\n"
                                     f"    golden.session({str(log)!r}, {str(arm)!r}, 'swing', pictures=False)\n")
    return pytester.runpytest_subprocess("-p", "rocinante.pytest_plugin", *words)


@pytest.mark.parametrize("form", FORMS)
def test_the_first_lines_of_a_verdict_are_its_causes(pytester, tmp_path, monkeypatch, form):
    monkeypatch.delenv("CI", raising=False)
    arm, log = foreign(tmp_path, form)
    swing(pytester, log, arm, "--golden-approve").assert_outcomes(passed=1)
    swing(pytester, log, arm).assert_outcomes(passed=1)
    _, other = foreign(tmp_path, form, "other", 0.5)
    failed = swing(pytester, other, arm)
    failed.assert_outcomes(failed=1)
    failed.stdout.re_match_lines([r".*golden swing: different: arm.*since 2\."])
    failed.stdout.no_fnmatch_line(f"*{other}*")
    page = (pytester.path / "golden-results/index.html").read_text()
    assert "arm/shoulder: " in page and "swing.report/index.html" in page and other.name in page


def test_sessions_accepted_beside_others_are_a_band(pytester, tmp_path, monkeypatch):
    monkeypatch.delenv("CI", raising=False)
    arm, first = foreign(tmp_path, "csv", "first")
    logs = {add: foreign(tmp_path, "csv", f"more{add}", add)[1] for add in (0.05, 0.1, 0.2)}
    swing(pytester, first, arm, "--golden-widen").assert_outcomes(passed=1)
    swing(pytester, logs[0.05], arm).assert_outcomes(failed=1)
    swing(pytester, logs[0.1], arm, "--golden-widen").assert_outcomes(passed=1)
    swing(pytester, logs[0.05], arm).assert_outcomes(passed=1)
    goldens = pytester.path / "goldens"
    assert sorted(each.name for each in goldens.iterdir()) == ["swing+2.csv", "swing.csv"]
    # To accept one in place of the others.
    swing(pytester, logs[0.2], arm).assert_outcomes(failed=1)
    swing(pytester, logs[0.2], arm, "--golden-approve").assert_outcomes(passed=1)
    assert sorted(each.name for each in goldens.iterdir()) == ["swing.csv"]
    swing(pytester, logs[0.1], arm).assert_outcomes(failed=1)
    monkeypatch.setenv("CI", "true")
    swing(pytester, logs[0.1], arm, "--golden-widen").assert_outcomes(failed=1)
    assert sorted(each.name for each in goldens.iterdir()) == ["swing.csv"]


def test_a_session_of_which_nothing_is_judged_is_not_accepted(pytester, tmp_path, monkeypatch):
    monkeypatch.delenv("CI", raising=False)
    arm, log = foreign(tmp_path, "pcap")
    arm.write_text(arm.read_text().replace("shoulder", "elbow"))
    refused = swing(pytester, log, arm, "--golden-approve")
    refused.assert_outcomes(failed=1)
    refused.stdout.fnmatch_lines(["*there is no accepted file yet*not accepted: *"])
    assert not (pytester.path / "goldens").exists()


def test_a_session_in_which_check_finds_errors_is_not_accepted(pytester, tmp_path, monkeypatch):
    monkeypatch.delenv("CI", raising=False)
    arm, log = foreign(tmp_path, "csv")
    narrow = arm.read_text().replace('lower="-2" upper="2"', 'lower="-0.1" upper="0.1"')
    assert narrow != arm.read_text()
    arm.write_text(narrow)
    for word in ("--golden-approve", "--golden-widen"):
        refused = swing(pytester, log, arm, word)
        refused.assert_outcomes(failed=1)
        refused.stdout.fnmatch_lines(["*not accepted: *[[]joint.limit]*pytest --golden-anyway accepts it*"])
        assert not (pytester.path / "goldens").exists()
    swing(pytester, log, arm, "--golden-approve", "--golden-anyway").assert_outcomes(passed=1)
    assert (pytester.path / "goldens/swing.csv").exists()


def test_a_folder_that_is_a_bag_is_accepted_as_it_is(pytester, tmp_path, monkeypatch):
    monkeypatch.delenv("CI", raising=False)
    for name, add in (("swing", 0), ("other", 0.05)):
        arm, bag = foreign(tmp_path, "bag.mcap", name, add)
        (tmp_path / name).mkdir()
        bag.rename(tmp_path / name / f"{name}_0.mcap")
        (tmp_path / name / "metadata.yaml").touch()
    swing(pytester, tmp_path / "swing", arm, "--golden-approve").assert_outcomes(passed=1)
    assert len(list((pytester.path / "goldens/swing").iterdir())) == 2
    swing(pytester, tmp_path / "swing", arm).assert_outcomes(passed=1)
    swing(pytester, tmp_path / "other", arm).assert_outcomes(failed=1)
