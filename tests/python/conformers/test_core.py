# SPDX-License-Identifier: MIT
"""Candidates from several starts and the choice among them, against RDKit and by definition."""

from functools import cache

import numpy as np
import pytest

pytest.importorskip("rdkit")
from libraries import embedded
from pliant.jobs.conformers import core
from pliant.jobs.conformers.options import ConformerOptions
from rdkit import Chem
from rdkit.Chem import AllChem, rdMolAlign
from rdkit.Chem.rdMolTransforms import GetDihedralDeg

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
PEPTOID = "C[C@@H]1NC(=O)CN(C)C(=O)CN(C)C(=O)CN(C)C(=O)CN(C)C1=O"
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


def test_amides_of_a_cyclic_peptoid_turn_and_stay_flat():
    peptoid = embedded(PEPTOID)
    amides = peptoid.GetSubstructMatches(Chem.MolFromSmarts("[CX4]C(=O)N([CX4;R])[CH3]"))
    assert len(amides) == 4
    place, states = peptoid.GetConformer(), set()
    for frame in drawn(PEPTOID).positions:
        place.SetPositions(frame)
        turns = [abs(GetDihedralDeg(place, a, c, n, b)) for a, c, _, n, b, _ in amides]
        assert max(min(turn, 180 - turn) for turn in turns) < 20  # of the start: 23
        states.add(tuple(turn < 90 for turn in turns))
        Chem.AssignStereochemistryFrom3D(peptoid)
        assert Chem.FindMolChiralCenters(peptoid)[0][1] == "S"
    assert len(states) > 4
