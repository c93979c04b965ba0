# SPDX-License-Identifier: MIT
"""A ligand that ``--around`` selects gets other torsions: measured by numpy."""

import numpy as np
import pytest
from made_trajectories import LIGAND, ligand_complex
from pliant.lab.validity.stereochemistry import Checker
from pliant.measure.geometry import torsions_of
from pliant.trajectory.opened import frames_of

import pliant

TURNED = 30.0  #: degrees


def draw(model, frames=60, **options):
    options = {"around": LIGAND, "amplitude": 0.2, "seed": 3, **options}
    return pliant.sample(model, frames, **options)


@pytest.fixture(scope="module")
def model():
    return pliant.build_model(ligand_complex())


@pytest.fixture(scope="module")
def drawn(model):
    return draw(model)


def turned(model, frames):
    """(F,) whether the acid or the ester of aspirin is turned about its bond to the ring."""
    s = model.structure
    own = np.flatnonzero(s.residue_names == "AIN")
    bonded = {k: [] for k in own}
    for a, b in s.bonds.tolist():
        if a in bonded and b in bonded:
            bonded[a].append(b)
            bonded[b].append(a)
    ring = [k for k in own if s.elements[k] == 6 and len(bonded[k]) == 3]
    ring = [k for k in ring if sum(j in ring for j in bonded[k]) > 1]
    ends = [(k, j) for k in ring for j in bonded[k] if j not in ring and s.elements[j] != 1]
    assert len(ends) == 2
    four = np.array(
        [
            (next(n for n in bonded[k] if n in ring), k, j, next(n for n in bonded[j] if n != k))
            for k, j in ends
        ]
    )
    start = torsions_of(np.asarray(model.positions), four)
    off = [np.abs((torsions_of(x, four) - start + 180) % 360 - 180).max() for x in frames]
    return np.array(off) > TURNED


def test_torsions_differ_in_half_of_the_frames_and_all_is_whole(model, drawn):
    frames = np.asarray(drawn.positions)
    assert len(frames) == 60
    assert drawn.ligand_frames > 50
    assert turned(model, frames).mean() > 0.5
    look = Checker(model).look(frames)
    assert look.worst_bar < 1e-9
    assert look.overlaps == look.flipped == 0


def test_the_ligand_stays_beside_its_site(model, drawn):
    own = model.structure.residue_names == "AIN"
    start = np.asarray(model.positions)
    apart = np.linalg.norm(start[own][:, None] - start[~own], axis=2)
    near = np.flatnonzero(~own)[apart.min(axis=0) < 6.0]
    for x in drawn.positions:
        now = np.linalg.norm(x[own][:, None] - x[near], axis=2)
        assert now.min() < 4.0


def test_bits_do_not_depend_on_threads(model, drawn):
    other = draw(model, 12, threads=2)
    np.testing.assert_array_equal(other.positions, np.asarray(drawn.positions)[:12])


def off_contacts(model, hold, folder):
    """(F, contacts of the ligand) which are off."""
    path = folder / "held.h5md"
    draw(model, 40, hold=hold, output=path, overwrite=True)
    contacts = frames_of(str(path)).contacts
    own = np.flatnonzero(model.structure.residue_names == "AIN")
    touches = np.isin(contacts.joints, own).sum(axis=1) == 1
    return contacts.states[:, touches] == 2


def test_contacts_are_held_or_let_go_by_choice(model, tmp_path):
    let_go = off_contacts(model, ["none"], tmp_path)
    assert let_go.shape[1] > 0
    assert let_go.any()
    assert not off_contacts(model, ["all"], tmp_path).any()


def test_refusals(model):
    with pytest.raises(pliant.OptionError, match="hold: no kind of contact named"):
        draw(model, hold=["hydrogen_bonds"])
    with pytest.raises(pliant.OptionError, match="hold: goes with a ligand that around selects"):
        draw(model, around="resid 5", hold=["all"])
