# SPDX-License-Identifier: MIT
"""Files of SAXS curves: what is read, and what is wrong with a line."""

import numpy as np
import pytest
from pliant.jobs.fit.saxs.curve import read_curve

import pliant

ROWS = [f"{0.01 * k:g} {100 - k} {1 + 0.1 * k:g}" for k in range(1, 31)]


def written(path, lines):
    (path / "curve.dat").write_text("\n".join(lines))
    return path / "curve.dat"


@pytest.mark.parametrize(
    ("before", "after", "separator"),
    [
        ([], [], " "),
        (["Sample: lysozyme", "", "  q   I   sigma"], ["# the end"], "  "),
        (["# q, I, sigma", "! buffer"], ["", ""], ","),
        (["q;I;s"], [], ";"),
        (["\ufeffq\tI\tsigma"], [], "\t"),
    ],
)
def test_headers_comments_and_separators(tmp_path, before, after, separator):
    rows = [row.replace(" ", separator) + " # 7" * (k == 3) for k, row in enumerate(ROWS)]
    curve = read_curve(written(tmp_path, [*before, *rows, *after]))
    assert curve.q == pytest.approx(0.01 * np.arange(1, 31))
    assert curve.intensity == pytest.approx(100 - np.arange(1, 31))
    assert curve.sigma == pytest.approx(1 + 0.1 * np.arange(1, 31))


def test_more_columns_are_let_be(tmp_path):
    assert len(read_curve(written(tmp_path, [row + " 5 x" for row in ROWS])).q) == 30


BAD = {
    "0.045 96": "4: sigma: expected three columns, q, I and sigma, found 2",
    "0.045": "4: I: expected three columns, q, I and sigma, found 1",
    "0.045 96 0": "4: sigma: expected a number above 0, found '0'",
    "0.045 96 -1": "4: sigma: expected a number above 0, found '-1'",
    "0.045 nan 1": "4: I: expected a number, found 'nan'",
    "0.045 96 nan": "4: sigma: expected a number above 0, found 'nan'",
    "0.045 inf 1": "4: I: expected a number, found 'inf'",
    "0.045 x 1": "4: I: expected a number, found 'x'",
    "end of data": "4: q: expected a number above 0, found 'end'",
    "-0.1 96 1": "4: q: expected a number above 0, found '-0.1'",
    "0.02 96 1": "4: q: expected more than in the row before, 0.03, found '0.02'",
    "0.03 96 1": "4: q: expected more than in the row before, 0.03, found '0.03'",
}


@pytest.mark.parametrize("line", BAD)
def test_a_bad_line_is_named(tmp_path, line):
    path = written(tmp_path, [*ROWS[:3], line, *ROWS[3:]])
    with pytest.raises(pliant.InputError) as raised:
        read_curve(path)
    assert str(raised.value) == f"{path}:{BAD[line]}"


@pytest.mark.parametrize(("count", "found"), [(0, 0), (7, 7)])
def test_too_few_points(tmp_path, count, found):
    path = written(tmp_path, ["header", *ROWS[:count]])
    with pytest.raises(pliant.InputError) as raised:
        read_curve(path)
    assert str(raised.value) == (
        f"{path}: expected 20 points or more up to 0.5 1/Angstrom, found {found}"
    )


def test_a_curve_of_nothing_is_refused(tmp_path):
    path = written(tmp_path, [row.replace(" ", " -", 1) for row in ROWS])
    with pytest.raises(pliant.InputError) as raised:
        read_curve(path)
    assert str(raised.value) == f"{path}: I: expected most numbers above 0, found 0 of 30"


def test_bytes_are_no_curve(tmp_path):
    (tmp_path / "curve.dat").write_bytes(b"\xff\xfe\x00")
    with pytest.raises(pliant.InputError, match=r"curve.dat: expected a text of columns"):
        read_curve(tmp_path / "curve.dat")


def test_nanometres_are_told_by_the_size_of_q(tmp_path):
    rows = [f"{0.1 * k:g} {100 - k} 1" for k in range(1, 31)]
    with pytest.warns(pliant.PliantWarning, match=r"q from 0.1 to 3: taken as 1/nm"):
        curve = read_curve(written(tmp_path, rows))
    assert curve.q == pytest.approx(0.01 * np.arange(1, 31))


def test_wide_angles_are_left_out(tmp_path):
    rows = [f"{0.02 * k:g} {200 - k} 1" for k in range(1, 101)]
    with pytest.warns(pliant.PliantWarning, match="75 points beyond 0.5 1/Angstrom are left out"):
        assert len(read_curve(written(tmp_path, rows)).q) == 25


def test_guinier(tmp_path):
    q = np.linspace(0.01, 0.3, 100)
    rows = [f"{x:.8g} {5 * np.exp(-((x * 20) ** 2) / 3):.8g} 0.01" for x in q]
    curve = read_curve(written(tmp_path, rows))
    for near in (12.0, 35.0):
        rg, error = curve.guinier(near)
        assert rg == pytest.approx(20, rel=1e-3)
        assert 0 < error < 0.5
    assert read_curve(written(tmp_path, rows[40:])).guinier(20.0) is None
