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


def test_a_complex_that_the_force_field_tears_apart_is_refused():
    torn = "N#CS[Cd](SC#N)([N+]1=CC=CC=C1)[N+]2=CC=CC=C2"
    with pytest.raises(pliant.InputError) as caught:
        pliant.from_smiles(torn)
    assert str(caught.value) == f"SMILES '{torn}': RDKit found no 3-D structure"
