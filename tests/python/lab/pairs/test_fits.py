# SPDX-License-Identifier: MIT
"""Fits to distances of the other structure: rows, shares, directions that are left out."""

import shutil
from pathlib import Path

import pytest

pytest.importorskip("MDAnalysisTests")
import MDAnalysisTests
from pliant.lab.pairs import fits as measure
from pliant.lab.pairs.directions import directions_of

DATA = Path(MDAnalysisTests.__file__).parent / "data"


@pytest.fixture
def pair(tmp_path):
    """Adenylate kinase, closed and open."""
    (tmp_path / "kinase").mkdir()
    for name in ("adk_closed.pdb", "adk_open.pdb"):
        shutil.copy(DATA / name, tmp_path / "kinase")
    return tmp_path


@pytest.mark.long
def test_fits_come_nearer_and_are_told_in_shares(pair, monkeypatch, capsys):
    monkeypatch.setattr(measure, "FRAMES", 100)
    monkeypatch.setattr(measure, "COUNTS", (3, 5))
    monkeypatch.setattr(measure, "directions_of", lambda folder: directions_of(folder)[1:])
    found = measure.fits(pair)
    errors = [f"10 designed, +-{error:g} A" for error in measure.OTHER_ERRORS]
    names = ["3 designed", "5 designed", *errors, measure.RANDOM, measure.MISTAKEN]
    maps = [name for name, *_ in measure.MAPS]
    assert [share.data for share in found.shares] == [
        *(name + more for name in names for more in ("", ", all atoms")),
        *(measure.CURVE, measure.NEAREST),
        *(name + more for name in maps for more in ("", ", all atoms")),
    ]
    of_curve = {share.data: share for share in found.shares}
    assert of_curve[measure.NEAREST].reached <= of_curve[measure.CURVE].reached
    assert of_curve[measure.CURVE].within is None
    best = found.shares[2]
    assert best.reached < 0.7 * best.at_start
    assert best.directions == 1
    assert best.seconds > 0
    found.print_report()
    assert "5 designed" in capsys.readouterr().out


def test_large_proteins_are_left_out(pair, capsys):
    found = measure.fits(pair, 100)
    assert found.rows == []
    assert len(found.skipped) == 2
    found.print_report()
    assert capsys.readouterr().out.count("more than 100 residues") == 2
