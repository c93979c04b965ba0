# SPDX-License-Identifier: MIT
"""Loops that ``--around`` redraws, of a bundle of helices, measured by numpy."""

from pathlib import Path

import numpy as np
import pytest
from pliant.lab.validity.stereochemistry import Checker
from pliant.measure.geometry import torsions_of

import pliant

BUNDLE = Path(__file__).parents[3] / "data" / "proteins" / "three_helices.pdb"
FIRST, LAST = 17, 20  #: of the first loop
HELD = 19


def atom(structure, residue, name):
    here = (structure.residue_ids == residue) & (structure.names == name)
    return int(np.flatnonzero(here)[0])


def frames_of(path, **options):
    model = pliant.build_model(path)
    around = f"resid {FIRST}-{LAST}"
    options = {"sampler": "pocket", "around": around, "amplitude": 0.5, "seed": 3, **options}
    return model, pliant.sample(model, 60, **options)


def backbone_turns(model, frames, residue):
    """How far phi and psi are from the start's in each frame, the further of them (degrees)."""
    s = model.structure
    names = [
        (residue - 1, "C"),
        (residue, "N"),
        (residue, "CA"),
        (residue, "C"),
        (residue + 1, "N"),
    ]
    five = np.array([atom(s, *name) for name in names])
    four = np.array([five[:4], five[1:]])
    start = torsions_of(np.asarray(model.positions), four)
    return np.array(
        [np.abs((torsions_of(x, four) - start + 180) % 360 - 180).max() for x in frames]
    )


@pytest.fixture(scope="module")
def drawn():
    return frames_of(BUNDLE)


def test_frames_are_as_whole_as_any(drawn):
    model, ensemble = drawn
    look = Checker(model).look(np.asarray(ensemble.positions))
    assert look.worst_bar < 1e-9
    assert look.overlaps == look.flipped == look.turned == 0
    assert look.outliers - look.outliers_of_start < 0.01
    assert look.clashes - look.clashes_of_start < 0.5


def test_loops_are_redrawn_and_helices_keep_their_torsions(drawn):
    model, ensemble = drawn
    loop = range(FIRST - 3, LAST)
    far = [backbone_turns(model, ensemble.positions, residue) for residue in loop]
    assert (np.max(far, axis=0) > 60).sum() >= 5
    for residue in (9, 28, 47):
        assert np.median(backbone_turns(model, ensemble.positions, residue)) < 20


def test_bits_do_not_depend_on_threads(drawn):
    _, ensemble = drawn
    _, again = frames_of(BUNDLE, threads=2)
    np.testing.assert_array_equal(ensemble.positions, again.positions)


def test_what_holds_a_metal_is_left_alone(drawn, tmp_path):
    """Zinc on the oxygen of a residue of the loop, 2.1 Angstrom away."""
    model, ensemble = drawn
    at = np.asarray(model.positions)
    c, o = (at[atom(model.structure, HELD, name)] for name in "CO")
    zinc = o + 2.1 * (o - c) / np.linalg.norm(o - c)
    lines = [line for line in BUNDLE.read_text().splitlines() if line.startswith("ATOM")]
    place = "".join(f"{x:8.3f}" for x in zinc)
    lines.append(f"HETATM 9000 ZN    ZN A 900    {place}  1.00  0.00          ZN")
    path = tmp_path / "zinc.pdb"
    path.write_text("\n".join([*lines, "END", ""]))
    held, with_zinc = frames_of(path)
    assert "metal" in set(map(str, held.framework.limits["kind"]))
    assert backbone_turns(model, ensemble.positions, HELD).max() > 60
    assert backbone_turns(held, with_zinc.positions, HELD).max() < 40
