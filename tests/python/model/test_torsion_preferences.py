# SPDX-License-Identifier: MIT
"""Torsion preferences beside MDAnalysis: which torsions they are, and what they do to frames."""

import expected_warnings
import numpy as np
import pytest

import pliant

MDA = pytest.importorskip("MDAnalysisTests.datafiles")
DATA = pytest.importorskip("MDAnalysis.analysis.data.filenames")
interpolate = pytest.importorskip("scipy.ndimage").map_coordinates

FREE = 15.0  #: degrees off staggered at which nothing pulls
OFF = 35.0  #: degrees off staggered that count as unusual
AFTER = {  # chi 2 and further about bonds of tetrahedral atoms, by the names of rotamer libraries
    2: {"LEU": "CD1", "ILE": "CD1", "LYS": "CD", "ARG": "CD", "GLN": "CD", "GLU": "CD",
        "MET": "SD"},
    3: {"LYS": "CE", "ARG": "NE", "MET": "CE"},
    4: {"LYS": "NZ"},
}  # fmt: skip  # some pairs a line
GAMMA = ("CG", "CG1", "OG", "OG1", "SG")


@pytest.fixture(scope="module")
def closed():
    structure = expected_warnings.read_without_elements(MDA.PDB_closed)
    structure.perceive_bonds()
    return structure


@pytest.fixture(scope="module")
def model(closed):
    return pliant.build_model(closed)


def torsions(x, rows):
    """Degrees (rows,), by the C library's arctan."""
    a, b, c, d = (x[..., rows[:, k], :] for k in range(4))
    u, v, w = b - a, c - b, d - c
    one, other = np.cross(u, v), np.cross(v, w)
    along = (np.cross(one, other) * v).sum(-1) / np.linalg.norm(v, axis=-1)
    return np.degrees(np.arctan2(along, (one * other).sum(-1)))


def off_staggered(degrees):
    return np.abs(np.mod(degrees, 120.0) - 60.0)


def chain_of(at, residue):
    """N, CA, CB and on, as far as tetrahedral atoms go, of atoms by name."""
    gamma = next((at[name] for name in GAMMA if name in at), None)
    if gamma is None or residue == "PRO":
        return []
    names = [at.get(AFTER[k].get(residue)) for k in (2, 3, 4)]
    chain = [at["N"], at["CA"], at["CB"], gamma]
    for atom in names:
        if atom is None:
            break
        chain.append(atom)
    return chain


def residues(structure):
    """Name, and atoms by name, of each residue."""
    atoms = {}
    for k, (name, residue) in enumerate(zip(structure.names, structure.residue_of, strict=True)):
        atoms.setdefault(int(residue), {})[name] = k
    return [(structure.residue_names[min(at.values())], at) for _, at in sorted(atoms.items())]


def side_chain_torsions(structure):
    chains = [chain_of(at, name) for name, at in residues(structure)]
    return [tuple(c[k : k + 4]) for c in chains for k in range(len(c) - 3)]


def backbone(structure, *, without):
    """C, N, CA, C, N of residues that are not called so."""
    at = residues(structure)
    return [
        (before["C"], here["N"], here["CA"], here["C"], after["N"])
        for (_, before), (name, here), (_, after) in zip(at, at[1:], at[2:], strict=False)
        if name not in without
    ]


def test_side_chains_are_those_of_rotamer_libraries(model):
    preferences = model.framework.torsion_preferences
    found = {tuple(row[:4]) for row in preferences.staggered}
    assert found == set(side_chain_torsions(model.structure))
    assert f"torsions: {len(found)} of side chains" in "\n".join(model.notes)


def test_backbone_is_all_but_ends_and_glycine(model):
    wanted = set(backbone(model.structure, without=("GLY",)))
    assert {tuple(row[:5]) for row in model.framework.torsion_preferences.backbone} == wanted


def test_nothing_pulls_at_the_start(closed, model):
    preferences = model.framework.torsion_preferences
    rows = np.array([row[:4] for row in preferences.staggered])
    off = off_staggered(torsions(np.asarray(model.positions), rows))
    free = np.array([row[4] for row in preferences.staggered])
    np.testing.assert_allclose(free, np.maximum(off, FREE), atol=1e-5)
    assert all(row[5] >= 1.0 for row in preferences.backbone)
    held, free = (
        pliant.sample(m, frames=2, amplitude=1e-5).positions
        for m in (model, pliant.build_model(closed, free_torsions=True))
    )
    assert np.abs(held - free).max() < 0.01  # Angstrom: limits aim 0.01 inside


def outliers(structure, x):
    """Share of residues outside the contour that holds 99 %, glycine and proline left out."""
    rows = np.array(backbone(structure, without=("GLY", "PRO")))
    phi, psi = torsions(x, rows[:, :4]), torsions(x, rows[:, 1:])
    places = [(psi.ravel() + 180.0) / 4.0, (phi.ravel() + 180.0) / 4.0]
    density = interpolate(np.load(DATA.Rama_ref), places, order=1, mode="grid-wrap")
    return float((density < 1.0).mean())


@pytest.mark.long
def test_frames_keep_rotamers_and_the_plot(closed, model):
    free = pliant.build_model(closed, free_torsions=True)
    assert free.framework.torsion_preferences is None
    rows = np.array(side_chain_torsions(model.structure))
    held_frames, free_frames = (pliant.sample(m, frames=30).positions for m in (model, free))
    held, loose = (
        float((off_staggered(torsions(x, rows)) > OFF).mean()) for x in (held_frames, free_frames)
    )
    start = np.asarray(model.positions)
    assert held < float((off_staggered(torsions(start, rows)) > OFF).mean()) + 0.01
    assert held < 0.7 * loose
    assert outliers(model.structure, held_frames) < outliers(model.structure, start) + 0.015
    assert outliers(model.structure, held_frames) < 0.7 * outliers(model.structure, free_frames)


def test_preferences_are_given_and_read():
    made = pliant.TorsionPreferences(
        staggered=[(0, 1, 2, 3, 20.0)], backbone=[(0, 1, 2, 3, 4, 1.5)]
    )
    framework = pliant.Framework([(0, 1)], [1.0], joint_count=5, torsion_preferences=made)
    there = framework.torsion_preferences
    assert there.staggered == [(0, 1, 2, 3, pytest.approx(20.0))]
    assert there.backbone == [(0, 1, 2, 3, 4, 1.5)]
    with pytest.raises(pliant.InputError, match="joint 9 of 5"):
        pliant.Framework(
            [(0, 1)],
            [1.0],
            joint_count=5,
            torsion_preferences=pliant.TorsionPreferences(staggered=[(0, 1, 2, 9, 20.0)]),
        )
