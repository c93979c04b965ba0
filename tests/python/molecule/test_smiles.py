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


@pytest.mark.parametrize(
    ("smiles", "left_open"),
    [
        ("CC(F)Cl", "1 stereo centre is"),
        ("FC=CF", "1 double bond is"),
        ("OCC1OC(O)C(O)C(O)C1O", "5 stereo centres are"),
        ("C/C=C/[C@H](O)C=CC(F)Cl", "1 stereo centre and 1 double bond are"),
        ("C[C@H](F)C(O)[C@H](C)F", "1 stereo centre is"),  # between an R and an S
        ("COP(=O)(S)OCC", "1 stereo centre is"),
        ("CC1CC2CCC1C2", "3 stereo centres are"),
        ("CC(N)C12CC3CC(CC(C3)C1)C2", "1 stereo centre is"),  # none of adamantane
        ("C1CCC2OC2C1", "2 stereo centres are"),  # RDKit may make the strained trans isomer
    ],
)
def test_stereo_that_is_left_open_is_counted(smiles, left_open):
    with pytest.warns(pliant.PliantWarning) as told:
        pliant.from_smiles(smiles)
    assert [str(one.message) for one in told] == [
        f"SMILES '{smiles}': {left_open} not given: one isomer was made"
    ]


@pytest.mark.parametrize(
    "smiles",
    "C[C@H](F)Cl C1CC2CCC1C2 C1CN2CCC1CC2 CN1C2CCC1CCC2 NC12CC3CC(C1)CC(C3)C2 NC(=N)c1ccccc1 "
    "COP(=O)(O)OCC COP(=O)([O-])OP(=O)([O-])OC CC(C)=C=CC C1CCCCC=C1 CC(=O)NC(C)C".split(),
)
def test_stereo_that_has_no_alternative_is_none(smiles):
    pliant.from_smiles(smiles)  # a warning would be an error


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
