# SPDX-License-Identifier: MIT
"""from_rdkit: atoms, bonds with orders, conformers, residues."""

import warnings

import numpy as np
import pytest

import pliant

chem = pytest.importorskip("rdkit.Chem")


NO_CONFORMER = (
    r"^the molecule has no conformer, so that its atoms have no positions: make one with "
    r"molecule = Chem\.AddHs\(molecule\); AllChem\.EmbedMolecule\(molecule, randomSeed=1\)$"
)


def embedded(smiles):
    from rdkit.Chem import AllChem

    molecule = chem.AddHs(chem.MolFromSmiles(smiles))
    assert AllChem.EmbedMolecule(molecule, randomSeed=7) == 0
    return molecule


@pytest.mark.parametrize(
    "smiles",
    ["CC(=O)Oc1ccccc1C(=O)O", "C#N", "[NH4+]", "C1CC2CCC1C2", "CS(=O)(=O)N", "[Na+].[Cl-]"],
)
def test_atoms_bonds_and_positions(smiles):
    molecule = embedded(smiles)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        structure = pliant.from_rdkit(molecule)
    assert structure.symbols.tolist() == [atom.GetSymbol() for atom in molecule.GetAtoms()]
    assert np.array_equal(structure.positions, molecule.GetConformer().GetPositions())
    kinds = {"SINGLE": 1, "DOUBLE": 2, "TRIPLE": 3, "AROMATIC": 4}
    expected = {
        tuple(sorted((b.GetBeginAtomIdx(), b.GetEndAtomIdx()))): kinds[str(b.GetBondType())]
        for b in molecule.GetBonds()
    }
    orders = structure.bond_orders.tolist()
    assert dict(zip(map(tuple, structure.bonds.tolist()), orders, strict=True)) == expected


def test_the_conformer_that_was_asked_for():
    from rdkit.Chem import AllChem

    molecule = embedded("CCCC")
    ids = list(AllChem.EmbedMultipleConfs(molecule, 3, randomSeed=5))
    structure = pliant.from_rdkit(molecule, ids[2])
    expected = molecule.GetConformer(ids[2]).GetPositions()
    assert np.array_equal(structure.positions, expected)
    with pytest.raises(pliant.InputError, match=r"^the molecule has no conformer 9; it has "):
        pliant.from_rdkit(molecule, 9)
    flat = chem.MolFromSmiles("CC")
    with pytest.raises(pliant.InputError, match=NO_CONFORMER):
        pliant.from_rdkit(flat)


def test_implicit_hydrogens_are_warned_of():
    molecule = chem.RemoveHs(embedded("CCO"))
    with pytest.warns(pliant.PliantWarning, match=r"left out: 6;") as caught:
        structure = pliant.from_rdkit(molecule)
    assert [warning.filename for warning in caught] == [__file__]
    assert structure.symbols.tolist() == ["C", "C", "O"]


def test_residues_of_a_pdb_file():
    block = (
        "ATOM      1  N   GLY A   1B      0.000   0.000   0.000  1.00  0.00           N\n"
        "ATOM      2  CA  GLY A   1B      1.450   0.000   0.000  1.00  0.00           C\n"
    )
    molecule = chem.MolFromPDBBlock(block, removeHs=False)
    with pytest.warns(pliant.PliantWarning):
        structure = pliant.from_rdkit(molecule)
    assert structure.label(1) == "CA(2)"
    assert structure.names.tolist() == ["N", "CA"]
    assert structure.residue_names.tolist() == ["GLY", "GLY"]
    assert structure.insertion_codes.tolist() == ["B", "B"]
    assert structure.chains.tolist() == ["A", "A"]
    molecule.SetProp("_Name", "half a residue")
    with pytest.warns(pliant.PliantWarning):
        assert pliant.from_rdkit(molecule).title == "half a residue"
