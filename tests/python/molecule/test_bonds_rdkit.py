# SPDX-License-Identifier: MIT
"""Bonds from positions alone against RDKit's, which knows them from the SMILES."""

import os
from pathlib import Path

import pytest
import support_program

pytest.importorskip("rdkit")
from rdkit import Chem, rdBase
from rdkit.Chem import AllChem

FLUORIDE = "RDKit has no force field for this atom and leaves fluorine atoms 0.9 Angstrom apart"
# Molecules whose bonds differ, as {name: (reason, differences)}. An entry that is not needed any
# more fails the test.
KNOWN_DIFFERENCES = {
    "sulfur-hexafluoride": (
        FLUORIDE,
        ["F(3) - F(4): ours only", "S(2) - F(3): theirs only", "S(2) - F(4): theirs only"],
    ),
    "phosphorus-pentafluoride": (
        FLUORIDE,
        ["F(1) - F(5): ours only", "F(1) - P(2): theirs only", "P(2) - F(5): theirs only"],
    ),
    "hexafluorophosphate": (
        FLUORIDE,
        [
            "F(1) - F(6): ours only",
            "F(3) - F(4): ours only",
            "F(1) - P(2): theirs only",
            "P(2) - F(3): theirs only",
            "P(2) - F(4): theirs only",
            "P(2) - F(6): theirs only",
        ],
    ),
}


#: whose positions RDKit takes as long to find as those of all others
LONG = () if os.environ.get("PLIANT_ALL") else ("paracyclophane",)


def smiles_and_names():
    path = support_program.ROOT / "tests/support/python/molecules.smi"
    lines = path.read_text().splitlines()
    rows = [line.split() for line in lines if line and not line.startswith("#")]
    return [row for row in rows if row[1] not in LONG]


def embedded(smiles):
    """The molecule with hydrogens and the positions that a force field likes."""
    molecule = Chem.AddHs(Chem.MolFromSmiles(smiles))
    options = AllChem.ETKDGv3()
    options.randomSeed = 20240607
    if AllChem.EmbedMolecule(molecule, options) != 0:  # strained: without knowledge of torsions
        plain = AllChem.EmbedParameters()
        plain.randomSeed = options.randomSeed
        plain.useRandomCoords = True
        assert AllChem.EmbedMolecule(molecule, plain) == 0, smiles
    if AllChem.MMFFHasAllMoleculeParams(molecule):
        AllChem.MMFFOptimizeMolecule(molecule, maxIters=2000)
    elif AllChem.UFFHasAllMoleculeParams(molecule):
        AllChem.UFFOptimizeMolecule(molecule, maxIters=2000)
    return molecule


@pytest.fixture(scope="module")
def compared(tmp_path_factory):
    """{name: (labels, our pairs, RDKit's pairs)}"""
    folder = tmp_path_factory.mktemp("xyz")
    files, theirs, names = [], [], []
    rdBase.DisableLog("rdApp.warning")  # atom types that the force field has to guess
    for smiles, name in smiles_and_names():
        molecule = embedded(smiles)
        files.append(folder / f"{name}.xyz")
        Path(files[-1]).write_text(Chem.MolToXYZBlock(molecule))
        ends = [(b.GetBeginAtomIdx(), b.GetEndAtomIdx()) for b in molecule.GetBonds()]
        theirs.append({(min(pair), max(pair)) for pair in ends})
        names.append(name)
    answers = support_program.bonds(files)
    return {
        name: (answer["labels"], answer["pairs"], pairs)
        for name, answer, pairs in zip(names, answers, theirs, strict=True)
    }


def test_there_are_many_molecules_of_different_names():
    names = [name for _, name in smiles_and_names()]
    assert len(names) >= 200
    assert len(set(names)) == len(names)


def test_bonds_equal_rdkits(compared):
    found = {
        name: support_program.differences(*three)
        for name, three in compared.items()
        if three[1] != three[2]
    }
    expected = {name: differences for name, (_, differences) in KNOWN_DIFFERENCES.items()}
    assert found == expected
