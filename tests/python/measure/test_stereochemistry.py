# SPDX-License-Identifier: MIT
"""Stereochemistry: flaws that a test puts in are found, and numbers are MDAnalysis'."""

import numpy as np
import pytest
from MDAnalysis.lib.distances import calc_angles, calc_dihedrals, capped_distance
from pliant.measure.geometry import angles_of, corners_of, out_of_plane, torsions_of
from pliant.measure.overlaps import Overlaps, ResidueContacts, within_three_bonds
from pliant.measure.ramachandran import ALLOWED, FAVOURED, OUTLIER, judged
from pliant.measure.stereochemistry import Stereochemistry

SYMBOLS = {6: "C", 7: "N", 8: "O"}


@pytest.fixture
def measured(peptide):
    elements = np.array([SYMBOLS[e] for e in peptide.elements])
    omega = [(1, 2, 5, 6), (6, 7, 10, 11), (11, 12, 15, 16)]
    phi = [(2, 5, 6, 7), (7, 10, 11, 12)]
    psi = [(5, 6, 7, 10), (10, 11, 12, 15)]
    return Stereochemistry(elements, peptide.bonds, peptide.positions, omega, phi, psi)


def test_angles_and_torsions_are_those_of_mdanalysis():
    positions = np.random.default_rng(1).standard_normal((40, 3)).astype(np.float32)
    triples, fours = np.arange(39).reshape(13, 3), np.arange(40).reshape(10, 4)
    theirs = np.degrees(calc_angles(*(positions[triples[:, k]] for k in range(3))))
    np.testing.assert_allclose(angles_of(positions.astype(float), triples), theirs, atol=1e-4)
    theirs = np.degrees(calc_dihedrals(*(positions[fours[:, k]] for k in range(4))))
    np.testing.assert_allclose(torsions_of(positions.astype(float), fours), theirs, atol=1e-4)


def test_the_start_has_no_flaw(measured, peptide):
    found = measured.run([peptide.positions])
    for name in ("angle", "angle_rms", "flips", "overlap", "overlaps"):
        assert getattr(found, name)[0] == 0
    assert found.omega[0] == pytest.approx(0, abs=1e-6)
    assert len(measured.corners.handed) == 4  # the CA of each alanine


def test_turning_a_torsion_changes_no_angle_but_omega(measured, peptide):
    frame = peptide.turned(peptide.positions, 2, 5, 50)
    found = measured.run([frame])
    assert found.angle[0] == pytest.approx(0, abs=1e-5)
    assert found.omega[0] == pytest.approx(50, abs=1e-6)
    assert found.twisted[0] == 1
    assert found.flips[0] == 0


def test_a_mirror_image_turns_every_centre_over(measured, peptide):
    found = measured.run([peptide.positions * [1, 1, -1]])
    assert found.flips[0] == len(measured.corners.handed) > 0
    assert found.angle[0] == pytest.approx(0, abs=1e-5)


def test_an_atom_out_of_its_plane_and_a_bent_angle_are_found(measured, peptide):
    (centre, *_), *_ = planar = measured.corners.planar.tolist()
    assert all(len(row) == 4 for row in planar)
    frame = peptide.positions.copy()
    one, two, three = (frame[k] for k in planar[0][1:])
    normal = np.cross(two - one, three - one)
    frame[centre] += 0.5 * normal / np.linalg.norm(normal)
    found = measured.run([frame])
    before = abs(out_of_plane(peptide.positions, np.array(planar[:1]))[0])
    assert found.plane[0] == pytest.approx(0.5, abs=before + 1e-9)
    assert found.angle[0] > 5


def test_overlaps_are_those_of_mdanalysis():
    random = np.random.default_rng(6)
    positions = random.uniform(0, 12, (120, 3))
    elements = random.choice(["C", "N", "O"], 120)
    bonds = np.array([(0, 1), (1, 2), (2, 3), (3, 4)])
    keys, depth = Overlaps(elements, bonds).of(positions)
    limits = {"CC": 3.0, "CN": 2.8, "CO": 2.7, "NN": 2.6, "NO": 2.6, "OO": 2.6}
    pairs, apart = capped_distance(positions, positions, 3.0)
    near = {(a, b) for a in range(4) for b in range(a + 1, min(a + 4, 5))}
    expected = {}
    for (i, j), distance in zip(pairs.tolist(), apart, strict=True):
        limit = limits["".join(sorted((elements[i], elements[j])))]
        if i < j and (i, j) not in near and distance < limit:
            expected[120 * i + j] = limit - distance
    assert keys.tolist() == sorted(expected)
    np.testing.assert_allclose(depth, [expected[key] for key in keys.tolist()], atol=1e-5)


def test_contacts_of_residues_are_those_of_a_loop():
    random = np.random.default_rng(8)
    positions = random.uniform(0, 15, (60, 3))
    units = np.repeat(np.arange(20), 3)
    chains = np.repeat(["A", "B"], 10)
    found = set(ResidueContacts(units, chains).of(positions).tolist())
    expected = set()
    for i in range(60):
        for j in range(60):
            a, b = units[i], units[j]
            apart = b - a > 3 or chains[a] != chains[b]
            if a < b and apart and np.linalg.norm(positions[i] - positions[j]) <= 4.5:
                expected.add(20 * a + b)
    assert found == expected


def test_the_regions_hold_the_residues_that_mdanalysis_counted():
    """Its 500 structures, without glycine's side: 90 % are favoured and 99 % no outliers."""
    from MDAnalysis.analysis.data.filenames import Rama_ref

    counts = np.load(Rama_ref)
    middle = -180 + 4 * np.arange(90) + 2
    phi, psi = np.meshgrid(middle, middle)
    left = phi < 0
    found = judged(phi, psi)
    total = counts[left].sum()
    assert 0.88 < counts[left & (found == FAVOURED)].sum() / total < 0.94
    assert counts[left & (found == OUTLIER)].sum() / total < 0.01
    assert np.mean(found == OUTLIER) > 0.5


@pytest.mark.parametrize(
    ("phi", "psi", "region"),
    [
        (-63, -43, FAVOURED),  # right-handed helix
        (-120, 130, FAVOURED),  # strand
        (-70, 150, FAVOURED),  # polyproline II
        (57, 40, FAVOURED),  # left-handed helix
        (-150, 60, ALLOWED),
        (60, -120, OUTLIER),
        (180, 0, OUTLIER),
    ],
)
def test_well_known_shapes_lie_where_they_should(phi, psi, region):
    assert judged(np.array([phi]), np.array([psi]))[0] == region


def test_hydrogens_that_are_absent_do_not_hide_a_hand(peptide):
    elements = np.array([SYMBOLS[e] for e in peptide.elements])
    corners = corners_of(peptide.bonds, elements, peptide.positions)
    assert set(corners.handed[:, 0].tolist()) <= {1, 6, 11, 16}
    assert set(corners.planar[:, 0].tolist()) <= {2, 7, 12}


def test_keys_of_near_atoms_have_room_in_large_molecules():
    """As 32-bit numbers they would run over from 46 341 atoms on."""
    count = 50_000
    keys = within_three_bonds(np.stack([np.arange(count - 1), np.arange(1, count)], axis=1), count)
    first, last = np.divmod(keys, count)
    assert len(keys) == 3 * count - 6 and set((last - first).tolist()) == {1, 2, 3}
