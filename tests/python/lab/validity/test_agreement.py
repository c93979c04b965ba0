# SPDX-License-Identifier: MIT
"""Measures of agreement beside what is known by hand, MDAnalysis and ProDy."""

import numpy as np
import pytest
from expected_warnings import read_without_elements
from pliant.lab.structures import amino_part, trace_of
from pliant.lab.validity.peers import Network, drawn_frames, network_of

import pliant
from pliant.measure import agreement as alike

MDA = pytest.importorskip("MDAnalysisTests.datafiles")


@pytest.fixture(scope="module")
def structure():
    return amino_part(read_without_elements(MDA.PDB_small))


@pytest.fixture(scope="module")
def kinase(structure):
    return trace_of(structure)


def test_the_overlap_of_known_modes():
    unit = np.eye(12)
    displacement = np.zeros(12)
    displacement[[3, 11]] = 3.0, 4.0
    assert alike.cumulative_overlap(unit, displacement.reshape(4, 3)) == pytest.approx(0.6)


def test_components_are_the_directions_that_frames_were_made_along():
    modes = np.linalg.qr(np.random.default_rng(5).normal(size=(30, 3)))[0].T
    amplitudes = np.random.default_rng(6).normal(size=(400, 3)) * [3.0, 2.0, 1.0]
    found = alike.components((amplitudes @ modes).reshape(400, 10, 3), 3)
    assert alike.rmsip(found, modes, 3) == pytest.approx(1.0)
    assert abs(found[0] @ modes[0]) > 0.98


def test_the_bootstrap_of_a_mean_is_its_standard_error():
    values = np.random.default_rng(7).normal(size=400)
    error = alike.bootstrap(400, lambda i: [values[i].mean()], 2000)[0]
    assert error == pytest.approx(values.std() / 20, rel=0.1)
    same = alike.bootstrap(400, lambda i: [values[i].mean()], 2000)[0]
    assert error == same


def test_an_ensemble_agrees_with_its_other_half_as_its_noise_lets_it():
    motion = np.random.default_rng(8).normal(size=(200, 1, 3)) * np.linspace(0.1, 2.0, 30)[:, None]
    start = 20 * np.random.default_rng(9).normal(size=(30, 3))
    r, inner = alike.halves(start + motion, 5)
    assert r > 0.98
    assert 0.9 < inner <= 1.0


def test_waters_ions_and_ligands_are_no_residues():
    atoms = "ATOM      1  N   ALA A   1       0.000   0.000   0.000  1.00  0.00           N\n"
    atoms += "ATOM      2  CA  ALA A   1       1.458   0.000   0.000  1.00  0.00           C\n"
    atoms += "ATOM      3  C   ALA A   1       2.009   1.420   0.000  1.00  0.00           C\n"
    atoms += "HETATM    4 CA    CA A   2      20.009   1.420   0.000  1.00  0.00          CA\n"
    atoms += "HETATM    5  O   HOH A   3      30.009   1.420   0.000  1.00  0.00           O\n"
    part = amino_part(pliant.read_text(atoms, "x.pdb"))
    assert list(part.names) == ["N", "CA", "C"]
    with pytest.raises(pliant.InputError, match="no residue has N, CA and C"):
        amino_part(pliant.read_text(atoms.splitlines()[4], "y.pdb"))


def test_anm_and_gnm_are_those_of_prody(structure, kinase):
    prody = pytest.importorskip("prody")
    prody.confProDy(verbosity="none")
    theirs, ours = prody.ANM(), network_of(structure, kinase, "anm")
    theirs.buildHessian(kinase.positions)
    theirs.calcModes(None)
    np.testing.assert_allclose(ours.variances, 1 / theirs.getEigvals(), rtol=1e-6)
    assert alike.rmsip(ours.directions.reshape(-1, 642), theirs.getEigvecs().T) > 1 - 1e-8
    rmsf = np.sqrt(prody.calcSqFlucts(theirs))
    np.testing.assert_allclose(ours.fluctuations, rmsf, rtol=1e-6)
    theirs, ours = prody.GNM(), network_of(structure, kinase, "gnm")
    theirs.buildKirchhoff(kinase.positions)
    theirs.calcModes(None)
    rmsf = np.sqrt(prody.calcSqFlucts(theirs))
    assert alike.correlation(ours.fluctuations, rmsf) == pytest.approx(1.0, abs=1e-9)


def test_a_peers_frames_have_the_rmsf_asked_for_and_whole_turns_stay_whole(structure, kinase):
    atoms, owner = kinase.positions + np.array([0.0, 0.0, 1.5]), np.arange(214)
    drawn = drawn_frames(
        network_of(structure, kinase, "anm"), kinase, kinase.positions, owner, 400, 0.9
    )
    assert alike.fluctuations(drawn).mean() == pytest.approx(0.9, rel=0.1)
    turn = np.cross([0.0, 0.0, 0.01], kinase.positions).reshape(1, 214, 3)
    whole = Network(np.ones(1), turn / np.linalg.norm(turn))
    frames = drawn_frames(whole, kinase, atoms, owner, 3, 0.05)
    away = frames - frames[:, :1] - (atoms - atoms[0])
    along = np.cross([0.0, 0.0, 1.0], atoms - atoms[0])
    size = (away * along).sum(axis=(1, 2), keepdims=True) / (along**2).sum()
    np.testing.assert_allclose(away, size * along, atol=1e-9)


def test_a_network_seen_on_some_residues_is_as_its_frames_superposed_on_these(structure, kinase):
    """Oracle: small frames of the Gaussian, superposed one by one."""
    network = network_of(structure, kinase, "anm")
    first = np.arange(60)
    amplitudes = np.random.default_rng(5).standard_normal((4000, len(network.variances)))
    amplitudes *= np.sqrt(network.variances)
    moved = np.einsum("fk,kni->fni", amplitudes, network.directions[:, first])
    moved *= 0.01 / np.abs(moved).max()
    frames = alike.superposed_on_mean(kinase.positions[first] + moved)
    alone = network.superposed(first, kinase.positions[first]).fluctuations
    drawn = alike.fluctuations(frames)
    np.testing.assert_allclose(drawn / drawn.mean(), alone / alone.mean(), rtol=0.06)
    assert alike.correlation(alone, network.fluctuations[first]) < 0.97  # not the same question


def test_what_only_turns_and_shifts_is_nothing_superposed():
    x = np.random.default_rng(6).normal(size=(9, 3))
    modes = [np.cross([0.3, -1.0, 0.2], x), np.full((9, 3), 0.5)]
    still = Network(np.ones(2), np.array(modes)).superposed(np.arange(9), x)
    np.testing.assert_allclose(still.fluctuations, 0.0, atol=1e-13)
