# SPDX-License-Identifier: MIT
"""Bonds that conformers used to keep: axes of atropisomers, fused rings of seven, amidines."""

from __future__ import annotations

import numpy as np
import pytest

import pliant

Chem = pytest.importorskip("rdkit.Chem")
rdMolTransforms = pytest.importorskip("rdkit.Chem.rdMolTransforms")

BINOL = "Oc1ccc2ccccc2c1-c1c(O)ccc2ccccc12"


def torsions(molecule, smarts: str) -> np.ndarray:
    """Degrees, of each conformer."""
    match = molecule.GetSubstructMatch(Chem.MolFromSmarts(smarts))
    assert len(match) == 4
    return np.array([rdMolTransforms.GetDihedralDeg(c, *match) for c in molecule.GetConformers()])


def hands(molecule) -> list[str]:
    return [one.GetProp("pliant_axes").split()[-1] for one in molecule.GetConformers()]


def test_both_hands_of_an_axis_are_made_where_none_was_given():
    """P is where the torsion of the senior groups, here the oxygens, is above 0 (IUPAC)."""
    made = pliant.conformers(BINOL, 20)
    between = torsions(made, "[c;$(cO)]:c-!@c:[c;$(cO)]")
    found = hands(made)
    assert set(found) == {"M", "P"}
    assert [hand == "P" for hand in found] == (between > 0).tolist()


def test_the_hand_of_an_axis_that_was_given_is_kept_and_named():
    one = Chem.Mol(pliant.conformers(BINOL, 1))
    given = hands(one)
    made = pliant.conformers(one, 20)
    assert set(hands(made)) == set(given)
    structure = pliant.from_rdkit(one)
    notes = pliant.conformers(structure, 5).notes
    assert f"axis C11-C12 cannot turn: it stays {given[0]}" in notes


def test_an_axis_with_two_like_sides_has_no_hand():
    made = pliant.conformers("Cc1cccc(C)c1-c1c(C)cccc1C", 5)
    assert not any(one.HasProp("pliant_axes") for one in made.GetConformers())


@pytest.mark.parametrize(
    "smiles",
    [
        "CN1C(=O)CN=C(c2ccccc2)c2cc(Cl)ccc21",
        "Cc1sc2c(c1C)C(c1ccc(Cl)cc1)=N[C@@H](CC(=O)Nc1nncs1)c1nnc(C)n1-2",
    ],
)
def test_benzodiazepines_flip(smiles: str):
    made = pliant.conformers(smiles, 50)
    beside = torsions(made, "[#6;R]-[#6;X4;R]-[#7;R]=[#6;R]")
    assert (beside > 30).any() and (beside < -30).any()
    centres = Chem.FindMolChiralCenters(Chem.MolFromSmiles(smiles))
    for one in made.GetConformers():
        Chem.AssignStereochemistryFrom3D(made, one.GetId())
        assert Chem.FindMolChiralCenters(Chem.RemoveHs(made)) == centres


def test_the_single_bond_of_an_amidine_turns():
    made = pliant.conformers("O=C1N=C(Nc2ccccc2)N=C1Cc1ccc2c(c1)OCO2", 50)
    turned = np.abs(torsions(made, "c-[NX3;H1]-[CX3;R]=[NX2;R]"))
    assert (turned < 45).any() and (turned > 135).any()
    assert ((turned < 60) | (turned > 120)).all()
