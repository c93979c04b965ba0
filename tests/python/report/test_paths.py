# SPDX-License-Identifier: MIT
"""Paths compared: distances by their definitions, by SciPy and MDAnalysis, and the command."""

import json
from functools import cache

import numpy as np
import pytest

pytest.importorskip("MDAnalysis")
MDA = pytest.importorskip("MDAnalysisTests.datafiles")
from expected_warnings import read_without_elements  # noqa: E402
from MDAnalysis.analysis.rms import rmsd  # noqa: E402
from pliant.measure.compared.paths import compare_paths, distances_of, frechet, straight_line  # noqa: E402
from pliant.report.compare.command import main  # noqa: E402
from pliant.trajectory.superposition import rmsd_to  # noqa: E402
from scipy.spatial.distance import cdist, directed_hausdorff  # noqa: E402

import pliant  # noqa: E402

DATA = MDA.PDB_small.rpartition("/")[0]


@pytest.fixture(scope="module")
def opening(tmp_path_factory):
    path = tmp_path_factory.mktemp("paths") / "opening.h5md"
    ends = [read_without_elements(f"{DATA}/adk_{name}.pdb") for name in ("closed", "open")]
    pliant.path(*ends, output=path)
    return path


def by_definition(table):
    """Of all walks from begin to end of both, neither backwards, the least largest distance."""

    @cache
    def reach(i, j):
        before = [reach(a, b) for a, b in ((i - 1, j), (i, j - 1), (i - 1, j - 1)) if a >= 0 <= b]
        return max(table[i, j], min(before, default=0.0))

    return reach(table.shape[0] - 1, table.shape[1] - 1)


@pytest.mark.parametrize("seed", range(20))
def test_frechet_is_its_definition(seed):
    draw = np.random.default_rng(seed)
    table = draw.uniform(size=draw.integers(1, 9, size=2))
    assert frechet(table) == by_definition(table)
    assert frechet(table.T) == frechet(table)


def test_hausdorff_is_scipys():
    draw = np.random.default_rng(3)
    one, other = draw.normal(size=(12, 5)), draw.normal(size=(7, 5))
    found = distances_of(cdist(one, other))
    expected = max(directed_hausdorff(one, other)[0], directed_hausdorff(other, one)[0])
    assert found.hausdorff == pytest.approx(expected)
    assert found.frechet >= found.hausdorff
    assert found.nearest_theirs == pytest.approx(cdist(one, other).min(axis=1).mean())


def test_rmsds_are_those_of_mdanalysis():
    draw = np.random.default_rng(4)
    one, other = 5.0 * draw.normal(size=(3, 9, 3)), 5.0 * draw.normal(size=(4, 9, 3))
    expected = [[rmsd(a, b, center=True, superposition=True) for b in other] for a in one]
    np.testing.assert_allclose(rmsd_to(one, other), expected, rtol=1e-6)


def test_a_line_begins_and_ends_where_it_should():
    draw = np.random.default_rng(6)
    first, last = draw.normal(size=(6, 3)), draw.normal(size=(6, 3))
    line = straight_line(first, last, 5)
    np.testing.assert_array_equal(line[0], first)
    assert rmsd_to(line[-1:], last[None])[0, 0] < 1e-6


def test_a_path_beside_a_transition_of_md(opening):
    found = compare_paths(opening, MDA.DCD, topology=MDA.PSF)
    assert found.residues == 214
    assert found.frames == (len(found.rmsd), 98)
    assert max(found.ends) < 0.6
    assert found.ours.hausdorff <= found.ours.frechet < 1.9
    assert found.line.frechet == pytest.approx(1.68, abs=0.01)
    backwards = distances_of(found.rmsd[::-1])
    assert backwards.frechet > 6.0  # the order of frames counts
    assert backwards.hausdorff == found.ours.hausdorff


def test_the_command_prints_both(opening, capsys):
    words = [str(opening), str(MDA.DCD), "--topology", str(MDA.PSF), "--path"]
    assert main(words) == 0
    out = capsys.readouterr().out
    assert "Frechet distance" in out and "straight line" in out
    assert main([*words, "--json", "--frames", "20"]) == 0
    found = json.loads(capsys.readouterr().out)
    assert found["frames"] == [20, 20]
    assert found["line"]["frechet"] > 1.0


@pytest.mark.parametrize(
    ("more", "code", "said"),
    [
        ([str(MDA.DCD), "--path"], 2, "--path: expected one file of THEIRS, found 2"),
        (["--path", "-o", "."], 2, "--output: --path draws no picture"),
    ],
)
def test_what_makes_no_sense_is_refused(opening, capsys, more, code, said):
    assert main([str(opening), str(MDA.DCD), *more]) == code
    assert said in capsys.readouterr().err


def test_a_single_structure_is_no_path(opening):
    with pytest.raises(pliant.InputError, match="expected at least 2 frames, found 1"):
        compare_paths(opening, f"{DATA}/adk_open.pdb")
