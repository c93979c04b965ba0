# SPDX-License-Identifier: MIT
"""Structures from SMILES, made by RDKit."""

import numpy as np
import pytest

import pliant

Chem = pytest.importorskip("rdkit.Chem")
IBUPROFEN = "CC(C)Cc1ccc(cc1)[C@@H](C)C(=O)O"


def test_a_smiles_has_all_hydrogens_in_three_dimensions():
    structure = pliant.from_smiles(IBUPROFEN)
    assert structure.title == IBUPROFEN
    assert len(structure) == 33 and np.count_nonzero(np.asarray(structure.elements) == 1) == 18
    assert np.linalg.svd(structure.positions - structure.positions.mean(axis=0))[1].min() > 1.0


def test_stereochemistry_is_that_of_the_smiles():
    from pliant.adapters.smiles import embedded

    molecule = Chem.RemoveHs(embedded(IBUPROFEN))
    Chem.AssignStereochemistryFrom3D(molecule)
    assert Chem.MolToSmiles(molecule) == Chem.CanonSmiles(IBUPROFEN)


def test_the_same_seed_gives_the_same_bits_and_another_another():
    one, again, other = (pliant.from_smiles(IBUPROFEN, seed=k).positions for k in (1, 1, 2))
    assert np.array_equal(one, again) and not np.allclose(one, other)


@pytest.mark.parametrize(
    ("smiles", "message"),
    [
        ("C1CC", "SMILES 'C1CC': expected a molecule, RDKit cannot read it"),
        ("", "SMILES '': expected a molecule, RDKit cannot read it"),
        ("CC.O", "SMILES 'CC.O': expected one molecule, found several ('.')"),
    ],
)
def test_what_is_no_molecule_is_said(smiles, message):
    with pytest.raises(pliant.InputError) as error:
        pliant.from_smiles(smiles)
    assert str(error.value) == message


@pytest.mark.parametrize(
    ("smiles", "what"),
    [
        ("N[Pt](N)(Cl)Cl", "RDKit makes no 3-D structure of the metal Pt"),
        (
            "N#CS[Cd](SC#N)([N+]1=CC=CC=C1)[N+]2=CC=CC=C2",
            "RDKit makes no 3-D structure of the metal Cd",
        ),
        (200 * "C", "expected at most 500 atoms to make 3-D, hydrogens included, found 602"),
        ("C1#CC1", "RDKit found no 3-D structure in 55 tries"),
    ],
)
def test_what_rdkit_cannot_embed_is_refused_at_once(smiles, what):
    with pytest.raises(pliant.InputError) as caught:
        pliant.from_smiles(smiles)
    assert str(caught.value) == f"SMILES '{smiles}': {what}"


@pytest.mark.long
def test_random_coordinates_help_where_others_do_not():
    assert len(pliant.from_smiles(100 * "C")) == 302


def test_a_limit_of_tries_changes_no_bits():
    from pliant.adapters.smiles import embed
    from rdkit.Chem import rdDistGeom, rdForceFieldHelpers

    one, other = (Chem.AddHs(Chem.MolFromSmiles(IBUPROFEN)) for _ in range(2))
    embed(one, "x", 3)
    options = rdDistGeom.ETKDGv3()
    options.randomSeed = 4
    rdDistGeom.EmbedMolecule(other, options)
    rdForceFieldHelpers.MMFFOptimizeMolecule(other, "MMFF94s", maxIters=2000)
    ours, theirs = (mol.GetConformer().GetPositions() for mol in (one, other))
    assert np.array_equal(ours, theirs)
