# SPDX-License-Identifier: MIT
"""Kinds of distances: dyes by their accessible volumes, atoms, NOE. Adenylate kinase."""

import copy
from pathlib import Path

import numpy as np
import pytest

import pliant

pytest.importorskip("MDAnalysisTests")
import MDAnalysisTests
from MDAnalysis.analysis.rms import rmsd
from pliant._core import accessible_volume
from pliant.jobs.fit.data import Sites, read_distances
from pliant.jobs.fit.labels import BACKBONE, RADII
from pliant.jobs.fit.nodes import distances

DATA = Path(MDAnalysisTests.__file__).parent / "data"
OPEN, CLOSED = DATA / "adk_open.pdb", DATA / "adk_closed.pdb"

pytestmark = pytest.mark.filterwarnings("ignore::pliant.PliantWarning")

#: designed, of residues that leave room for a dye in both shapes
DYES = (
    *((42, 148), (25, 128), (55, 162), (143, 203), (56, 148)),
    *((148, 187), (74, 137), (54, 128), (43, 75), (137, 199)),
)


@pytest.fixture(scope="module")
def closed():
    return pliant.read(CLOSED)


def sites_of(structure):
    return Sites(structure, np.flatnonzero(structure.names == "CA"))


def atom(structure, residue, name):
    return structure.positions[(structure.residue_ids == residue) & (structure.names == name)][0]


def around(structure, residue):
    """Heavy atoms but those of its own side chain, and their radii."""
    side = (structure.residue_ids == residue) & ~np.isin(structure.names, BACKBONE)
    some = (structure.elements > 1) & ~side
    radii = [RADII.get(int(element), 1.8) for element in structure.elements[some]]
    return structure.positions[some], np.array(radii)


def test_a_dye_is_in_the_middle_of_its_volume(closed):
    sites = sites_of(closed)
    row = {"site1": 55, "site2": 162, "distance": 30, "error": 5, "kind": "FRET"}
    datum = read_distances([row], sites)[0]
    ends = [
        accessible_volume(*around(closed, residue), atom(closed, residue, "CB")).mean(axis=0)
        for residue in (55, 162)
    ]
    apart = np.linalg.norm(ends[0] - ends[1])
    nodes = closed.positions[closed.names == "CA"]
    assert distances(nodes, [datum])[0] == pytest.approx(apart, abs=1.0)


def test_volumes_are_those_of_another_program(closed):
    """LabelLib, on a grid twice as fine; without atoms that its linker cannot leave."""
    library = pytest.importorskip("LabelLib")
    off = []
    for residue in range(11, 212, 6):
        attached = atom(closed, residue, "CB")
        atoms, radii = around(closed, residue)
        away = np.linalg.norm(atoms - attached, axis=1) > 4.05
        ours = accessible_volume(atoms[away], radii[away], attached)
        given = np.vstack([atoms[away].T, radii[away]]).astype(np.float32)
        grid = library.dyeDensityAV1(given, attached.astype(np.float32), 20.0, 4.5, 3.5, 0.5)
        points = np.argwhere(np.reshape(grid.grid, grid.shape, order="F") > 0)
        if len(ours) and len(points):
            theirs = 0.5 * points.mean(axis=0) + grid.originXYZ
            off.append(np.linalg.norm(ours.mean(axis=0) - theirs))
    assert len(off) >= 15
    assert np.median(off) < 0.3
    assert max(off) < 2.5


@pytest.mark.long
def test_distances_of_dyes_close_it(closed):
    sites, nodes = sites_of(closed), closed.positions[closed.names == "CA"]
    rows = [{"site1": a, "site2": b, "high": 1, "kind": "FRET"} for a, b in DYES]
    apart = distances(nodes, read_distances(rows, sites))
    rows = [
        {"site1": a, "site2": b, "distance": d, "error": 3, "kind": "FRET"}
        for (a, b), d in zip(DYES, apart, strict=True)
    ]
    fit = pliant.fit(OPEN, rows)
    found = fit.positions[0][fit.structure.names == "CA"]
    assert rmsd(found, nodes, superposition=True) < 2.5  # of alpha carbons, not dyes: above 5
    there = copy.deepcopy(fit.structure)
    there.positions = fit.positions[0]
    apart = distances(found, read_distances(rows, sites_of(there)))
    assert [one.found for one in fit.data] == pytest.approx(apart.tolist())
    assert sum(abs(one.violation) < 1 for one in fit.data) >= 8


def test_distances_of_atoms_are_theirs():
    one = {"site1": "resid 41 and name CB", "site2": "resid 148 and name CB", "kind": "atom"}
    structure = pliant.read(OPEN)
    here = np.linalg.norm(atom(structure, 41, "CB") - atom(structure, 148, "CB"))
    fit = pliant.fit(OPEN, [one | {"low": here - 5, "high": here - 3}], frames=60)
    moved = fit.structure
    at = [
        np.flatnonzero((moved.residue_ids == r) & (moved.names == n))[0]
        for r, n in ((41, "CB"), (148, "CB"))
    ]
    found = np.linalg.norm(fit.positions[0][at[0]] - fit.positions[0][at[1]])
    assert fit.data[0].at_start == pytest.approx(here, abs=1e-3)
    assert fit.data[0].found == pytest.approx(found)
    assert fit.data[0].violation == pytest.approx(
        max(0, found - here + 3) + min(0, found - here + 5)
    )


def test_hydrogens_of_an_noe_count_by_the_sixth_power():
    sites = ("resid 55 and name HB*", "resid 170 and name HB*")
    row = {"site1": sites[0], "site2": sites[1], "high": 30, "kind": "NOE"}
    fit = pliant.fit(OPEN, [row], frames=60)
    points = []
    for residue in (55, 170):
        of = (fit.structure.residue_ids == residue) & (fit.structure.elements == 1)
        beta = np.char.startswith(fit.structure.names.astype(str), "HB")
        points.append(fit.positions[0][of & beta])
    sixth = sum(np.linalg.norm(a - b) ** -6.0 for a in points[0] for b in points[1])
    assert len(points[0]) * len(points[1]) > 1
    assert fit.data[0].found == pytest.approx(sixth ** (-1 / 6))
    assert fit.data[0].high == 30
    assert fit.data[0].found < 31


def test_an_ambiguous_noe_is_of_whichever_is_near(closed):
    """By places of residues as by atoms: hydrogens of a backbone are where they are placed."""
    row = {"site1": "resid 12 13 and name HN", "site2": "resid 85 90 and name HN", "high": 5}
    datum = read_distances([row | {"kind": "NOE"}], sites_of(closed))[0]
    apart = [
        np.linalg.norm(atom(closed, a, "HN") - atom(closed, b, "HN"))
        for a in (12, 13)
        for b in (85, 90)
    ]
    sixth = np.sum(np.power(apart, -6.0)) ** (-1 / 6)
    nodes = closed.positions[closed.names == "CA"]
    other = read_distances([FRET], sites_of(closed))[0]
    for data in ([datum], [other, datum, other]):
        found = distances(np.array([nodes, nodes + 1]), data)
        assert found.shape == (2, len(data))
        assert found[:, len(data) // 2] == pytest.approx(sixth)
    assert datum.name == "12 - 85 or 12 - 90 or 13 - 85 or 13 - 90"
    assert datum.loosely[1] == pytest.approx(5 * 4 ** (1 / 6) + datum.slack)
    fit = pliant.fit(OPEN, [row | {"kind": "NOE", "high": 30}], frames=60)
    assert fit.data[0].name == datum.name
    assert fit.data[0].found < 31


NOE = {"site1": "resid 55 and name HB*", "site2": "resid 170 and name HB*", "kind": "NOE"}
ATOM = {"site1": "resid 55 and name CB", "site2": "resid 170 and name CB", "kind": "atom"}
FRET = {"site1": 55, "site2": 162, "distance": 30, "error": 3, "kind": "FRET"}
BAD = {
    "no room": (
        FRET | {"site2": 29},
        "site2: expected a residue that leaves room for a dye in START, found '29'",
    ),
    "an end": (
        FRET | {"site1": 1},
        "site1: expected an amino acid that is not the end of a chain, for a label, found '1'",
    ),
    "no limit": (NOE, "distance: expected distance and error, or low and high, found ''"),
    "no hydrogens": (
        NOE | {"site1": "resid 55 and name CB", "high": 5},
        "site1 'resid 55 and name CB': expected hydrogens, found 1 other atoms; START has those of "
        "its file and on N, O and S; all_hydrogens adds the others, on carbon",
    ),
    "two atoms": (
        ATOM | {"site1": "resid 55 and name CB CA", "high": 5},
        "site1 'resid 55 and name CB CA': expected one atom, as 'resid 45 and name CB', found 2",
    ),
    "one residue": (
        ATOM | {"site2": "resid 55 and name CA", "high": 5},
        "site2: expected another residue than site1, 55, found 'resid 55 and name CA'",
    ),
}


@pytest.mark.parametrize("name", BAD)
def test_what_is_wrong_is_said(closed, name):
    row, expected = BAD[name]
    with pytest.raises(pliant.InputError) as raised:
        read_distances([row], sites_of(closed))
    assert str(raised.value) == f"distances[0]: {expected}"
