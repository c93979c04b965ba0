# SPDX-License-Identifier: MIT
"""Candidates from several starts and the choice among them, against RDKit and by definition."""

from functools import cache

import numpy as np
import pytest

import pliant

pytest.importorskip("rdkit")
from libraries import embedded
from pliant.jobs.conformers import core
from pliant.jobs.conformers.options import ConformerOptions
from rdkit import Chem
from rdkit.Chem import AllChem, rdMolAlign

from pliant import _core

SYMMETRIC = (
    "CC(C)(C)c1ccc(cc1)CC(F)F",  # 24 of at most 64 that are tried
    "CCN(CC)CC(=O)Nc1c(C)cccc1C",
    "CS(=O)(=O)c1ccc(cc1)-c1ccccc1",
    "OCC(CO)(CO)CO",
    "C1CCCCC1CC(C)C",
)
CHIRAL = (
    "CC[C@H](C)[C@H](N)C(=O)NCC",
    "C[C@@H](O)/C=C/CC(=O)OCC",
    "C/C=C\\[C@H](F)CCO",
    "O[C@@H]1CC[C@H](CC(C)C)CC1(C)C",
    "C[C@H](CC)[S@](=O)CCC",
    "CN1CC[C@@H]2CCCC[C@H]2[C@H]1CCO",
)
DRUG = "CCN(CC)C[C@@H](O)COc1ccc(CCNC(C)=O)cc1"


@cache
def structure_of(smiles):
    return _core.read_text(Chem.MolToMolBlock(embedded(smiles)), "x.sdf", format="sdf")


@cache
def drawn(smiles, frames=60, threads=1):
    return core.draw(structure_of(smiles), ConformerOptions(frames=frames, seed=3), threads)


@pytest.mark.parametrize("smiles", SYMMETRIC)
def test_rmsd_is_the_best_of_all_symmetries_as_rdkit_finds_it(smiles):
    molecule = embedded(smiles)
    AllChem.EmbedMultipleConfs(molecule, 5, randomSeed=5)
    frames = np.array([one.GetPositions() for one in molecule.GetConformers()])
    found = _core._symmetric_rmsd(structure_of(smiles), frames[:3], frames[3:]).reshape(3, 2)
    heavy = Chem.RemoveHs(molecule)
    for k in range(3):
        for goal in range(2):
            expected = rdMolAlign.GetBestRMS(Chem.Mol(heavy), heavy, k, 3 + goal)
            assert found[k, goal] == pytest.approx(expected, abs=1e-6)


def test_a_mirror_image_is_another_shape():
    structure = structure_of(CHIRAL[0])
    own = np.array(structure.positions)[None]
    assert _core._symmetric_rmsd(structure, own, own)[0] == pytest.approx(0, abs=1e-7)
    assert _core._symmetric_rmsd(structure, own, own * (1, 1, -1))[0] > 0.3


def distances_between(structure, positions):
    return _core._symmetric_rmsd(structure, positions, positions).reshape(2 * (len(positions),))


def test_the_chosen_differ_and_the_lowest_is_first():
    structure, made = structure_of(DRUG), drawn(DRUG, 200)
    kept = core.choose(structure, made.positions, made.score, ConformerOptions(max=20, rms=0.7))
    assert len(kept) == len(set(kept.tolist())) == 20
    assert kept[0] == made.score.argmin()
    assert np.all(np.diff(made.score[kept]) >= 0)
    apart = distances_between(structure, made.positions[kept])
    assert apart[np.triu_indices(20, 1)].min() > 0.7
    within = core.choose(
        structure, made.positions, made.score, ConformerOptions(max=200, rms=0.7, window=4.0)
    )
    assert 1 < len(within) < 200
    assert np.ptp(made.score[within]) <= 4.0


def test_as_many_are_chosen_as_fit():
    """Each that is left out is within `rms` of a chosen one, or there are `max`."""
    structure, made = structure_of("CCCCCO"), drawn("CCCCCO", 100)
    kept = core.choose(structure, made.positions, made.score, ConformerOptions(max=100))
    assert 3 < len(kept) < 100
    apart = _core._symmetric_rmsd(structure, made.positions, made.positions[kept])
    assert apart.reshape(100, -1).min(axis=1).max() <= 0.5
    everything = core.choose(
        structure, made.positions, np.zeros(100), ConformerOptions(max=100, rms=0.0)
    )
    assert everything.tolist() == list(range(100))


def held_pairs(structure):
    """Bonds, and the ends of angles at atoms that are in no ring."""
    molecule = embedded(DRUG)
    bonds = [tuple(pair) for pair in structure.bonds.tolist()]
    near = [[one.GetIdx() for one in atom.GetNeighbors()] for atom in molecule.GetAtoms()]
    ends = [
        (a, b)
        for atom in molecule.GetAtoms()
        if not atom.IsInRing()
        for a in near[atom.GetIdx()]
        for b in near[atom.GetIdx()]
        if a < b
    ]
    return np.array(bonds), np.array(ends)


def lengths(positions, pairs):
    return np.linalg.norm(positions[:, pairs[:, 0]] - positions[:, pairs[:, 1]], axis=-1)


def test_each_conformer_has_the_bars_of_its_start():
    structure, made = structure_of(DRUG), drawn(DRUG)
    assert len(made.starts) == 5
    assert np.array_equal(made.starts[0], structure.positions)
    assert sorted(set(made.start.tolist())) == [0, 1, 2, 3, 4]
    assert np.bincount(made.start).tolist() == 5 * [12]
    bonds, ends = held_pairs(structure)
    for pairs in (bonds, ends):
        of_starts = lengths(made.starts, pairs)
        off = np.abs(lengths(made.positions, pairs) / of_starts[made.start] - 1)
        assert off.max() < 1e-9
    assert 0 < made.worst_bar < 1e-9
    changed = np.abs(of_starts[1:] - of_starts[0]).max(axis=1)
    assert np.all((changed > 0.01) & (changed < 0.5)), "angles of a start are those of the first"


def test_the_bits_are_the_same_each_time():
    made, again = drawn(DRUG), drawn(DRUG, threads=2)
    for name in ("positions", "start", "score", "starts"):
        assert np.array_equal(getattr(made, name), getattr(again, name)), name
    other = core.draw(structure_of(DRUG), ConformerOptions(frames=60, seed=4))
    assert not np.array_equal(made.positions, other.positions)


def test_one_start_has_the_frames_of_sample():
    structure = structure_of(DRUG)
    made = core.draw(structure, ConformerOptions(starts=1, frames=30, seed=8))
    assert np.array_equal(made.positions, pliant.sample(structure, 30, seed=8).positions)
    assert made.start.tolist() == 30 * [0]


def stereo_of(smiles, positions):
    """The SMILES of a molecule whose stereo is that of its positions."""
    molecule = embedded(smiles)
    molecule.GetConformer().SetPositions(np.ascontiguousarray(positions))
    Chem.AssignStereochemistryFrom3D(molecule)
    return Chem.MolToSmiles(Chem.RemoveHs(molecule))


@pytest.mark.long
@pytest.mark.parametrize("smiles", CHIRAL)
def test_starts_and_conformers_keep_handedness_and_double_bonds(smiles):
    made, expected = drawn(smiles), Chem.CanonSmiles(smiles)
    found = {stereo_of(smiles, one) for one in (*made.starts, *made.positions)}
    assert found == {expected}
    assert len(made.starts) > 1
    assert stereo_of(smiles, made.positions[7] * (1, 1, -1)) != expected
