# SPDX-License-Identifier: MIT
"""Fits of adenylate kinase, open, to maps of the closed one."""

import json
from pathlib import Path

import numpy as np
import pytest

import pliant

pytest.importorskip("MDAnalysisTests")
import MDAnalysisTests
from pliant.jobs.fit.command import main
from pliant.measure.ramachandran import OUTLIER, judged

DATA = Path(MDAnalysisTests.__file__).parent / "data"
OPEN, CLOSED = DATA / "adk_open.pdb", DATA / "adk_closed.pdb"
AWAY = np.array([[0, -1, 0], [1, 0, 0], [0, 0, 1.0]])  #: a quarter of a turn
RESOLUTION = 8.0

pytestmark = pytest.mark.filterwarnings("ignore::pliant.PliantWarning")


def alpha_carbons(structure):
    return np.flatnonzero((structure.names == "CA") & (structure.elements == 6))


@pytest.fixture(scope="module")
def closed():
    """The closed structure, turned away from the open one."""
    structure = pliant.read(CLOSED)
    structure.positions = structure.positions @ AWAY + 40.0
    return structure


@pytest.fixture(scope="module")
def density(closed):
    return pliant.DensityMap.from_structure(closed, RESOLUTION)


@pytest.fixture(scope="module")
def closing(density):
    waves = np.sin(np.arange(density.values.size)).reshape(density.shape)
    half = density.values + 0.02 * density.values.max() * waves
    half = pliant.DensityMap(half, density.spacing, density.origin)
    return pliant.fit(
        OPEN, map=density, resolution=RESOLUTION, half=half, place=True, frames=50, keep=2
    )


def test_a_map_closes_it_where_the_map_is(closing, closed):
    found = closing.positions[0][alpha_carbons(closing.structure)]
    off = found - closed.positions[alpha_carbons(closed)]
    assert np.sqrt((off**2).sum(axis=1).mean()) < 1.5  # open and closed: 6.9
    assert closing.agrees
    assert closing.density.found > 0.9 > 0.7 > closing.density.at_start
    assert closing.verdict().startswith("Structure and map agree: correlation 0.9")


def test_its_bars_are_exact(closing):
    bars, rest = closing.model.framework.bars, closing.model.framework.rest_lengths
    for positions in closing.positions:
        lengths = np.linalg.norm(positions[bars[:, 1]] - positions[bars[:, 0]], axis=1)
        assert np.abs(lengths / rest - 1).max() < 1e-9
    assert max(one.overlap for one in closing.kept) <= 0.1


def test_its_backbone_is_as_good_as_that_of_start(closing):
    mda = pytest.importorskip("MDAnalysis")
    angles = pytest.importorskip("MDAnalysis.analysis.dihedrals")
    assert closing.outliers <= closing.outliers_at_start + 0.02
    universe = mda.Universe(OPEN)
    with_side_chain = universe.select_atoms("protein and not resname GLY PRO")
    found = angles.Ramachandran(with_side_chain, check_protein=False).run().results.angles[0]
    assert closing.outliers_at_start == pytest.approx(
        (judged(*found.T) == OUTLIER).mean(), abs=1e-3
    )


def test_the_other_half_judges_it(closing):
    assert closing.density.judged_at_start < closing.density.judged < closing.density.found
    assert not closing.density.is_overfitted
    freedom = closing.density.freedom
    assert [one.strain for one in freedom] == sorted(one.strain for one in freedom)
    assert all(one.judged < one.correlation for one in freedom)


def test_correlations_are_those_of_the_map(closing, density):
    moved = pliant.read(OPEN)
    moved.positions = closing.positions[0]
    assert closing.density.found == pytest.approx(density.correlation(moved, RESOLUTION))
    assert len(closing.density.by_residue) == 214
    assert closing.density.unsupported == []
    assert closing.density.unexplained < 0.05
    assert (closing.spread >= RESOLUTION / 16).all()


@pytest.mark.long
def test_residues_without_density_are_named(closed, tmp_path, capsys):
    here = pliant.read(OPEN)
    kept = np.asarray(here.residue_ids) < 170
    part = pliant.Structure(here.positions[kept], elements=here.elements[kept])
    pliant.DensityMap.from_structure(part, RESOLUTION).save(tmp_path / "part.mrc")
    words = [str(OPEN), "--map", str(tmp_path / "part.mrc"), "--resolution", "8", "--frames", "50"]
    assert main([*words, "-o", str(tmp_path / "out.pdb"), "--json"]) == 0
    report = json.loads(capsys.readouterr().out)
    bare = [int(label.split(":")[-1]) for label in report["map"]["unsupported"]]
    assert sum(number < 168 for number in bare) <= 2
    assert set(range(185, 212)) <= set(bare)
    assert "No density supports" in report["verdict"]


def wrong(tmp_path, **given):
    with pytest.raises(pliant.Error) as raised:
        pliant.fit(OPEN, frames=50, output=tmp_path / "o.pdb", **given)
    assert not (tmp_path / "o.pdb").exists()
    return str(raised.value)


def test_bad_options_and_maps_are_told(tmp_path, density):
    away = pliant.DensityMap(density.values, density.spacing, density.origin + 500)
    assert wrong(tmp_path) == "give distances, a map, or both; or saxs"
    assert wrong(tmp_path, map=density) == (
        "resolution: a map needs it, in Angstrom; a header does not say it"
    )
    assert wrong(tmp_path, map=density, resolution=0.1).startswith("resolution = 0.1: must be")
    assert wrong(tmp_path, distances=[], resolution=8.0) == (
        "resolution, half, place: of a map, and none is given"
    )
    assert wrong(tmp_path, map=away, resolution=8.0) == (
        "density map: the molecule lies outside of it; put it there first (place)"
    )
    assert "map: mode (word 4): expected" in wrong(tmp_path, map=OPEN, resolution=8.0)
