# SPDX-License-Identifier: MIT
"""Hydrogens that are missing are found, named and added: RDKit is asked which they are."""

import numpy as np
import pytest

import pliant

pytest.importorskip("rdkit")
from libraries import embedded, record
from pliant.jobs.conformers.hydrogens import missing_hydrogens
from pliant.jobs.conformers.mol_block import parse
from pliant.jobs.conformers.options import ConformerOptions
from pliant.jobs.conformers.records import Record
from pliant.jobs.conformers.subject import subject_of, subject_of_mol, subject_of_structure
from rdkit import Chem

FAST = {"frames": 20, "starts": 1}
WHOLE = (
    "C[N+]#[C-] CN=[N+]=[N-] C[S+](C)C c1cc[nH]c1 C[N+](=O)[O-] CS(=O)(=O)N C[B-](F)(F)F "
    "C[O+](C)C CP(=O)(O)OC C[Si](C)(C)C Cn1cnc2c1c(=O)n(C)c(=O)n2C c1ccoc1 C#N CS CSC[SH] CS(C)=O "
    "C[SiH2]C CB(O)O CP C[PH](=O)OC C[PH3+] C[SeH] c1ccsc1 C[S-] CC(=O)[O-] C[NH3+] C[AsH2] "
    "CS(F)(F)(F)(F)F F[P-](F)(F)(F)(F)F C[BH3-] C[n+]1ccccc1 [O-][n+]1ccccc1 [C-]#[O+]"
).split()


def record_of(molecule):
    """The text of a molecule at any positions that are not flat."""
    made = Chem.Mol(molecule)
    places = Chem.Conformer(made.GetNumAtoms())
    places.SetPositions(np.random.default_rng(1).normal(size=(made.GetNumAtoms(), 3)) / 9)
    made.AddConformer(places)
    return Chem.MolToMolBlock(made, kekulize=False)


def without(molecule, *atoms):
    """The molecule without these hydrogens (numbers from 0), and without notes of RDKit on them."""
    made = Chem.RWMol(molecule)
    for k in sorted(atoms, reverse=True):
        made.RemoveAtom(k)
    for atom in made.GetAtoms():
        atom.SetNoImplicit(False)
        atom.SetNumExplicitHs(0)
    made.UpdatePropertyCache()
    return made.GetMol()


def missing_of(text):
    return missing_hydrogens(pliant.read_text(text, "x.sdf"), parse(text).radicals)


@pytest.mark.parametrize("smiles", WHOLE)
def test_which_are_missing_is_what_rdkit_says(smiles):
    whole = Chem.AddHs(Chem.MolFromSmiles(smiles))
    assert missing_of(record_of(whole)) == {}, "bonds of aromatic order"
    Chem.Kekulize(whole, clearAromaticFlags=True)
    assert missing_of(record_of(whole)) == {}
    hydrogens = [atom.GetIdx() for atom in whole.GetAtoms() if atom.GetAtomicNum() == 1]
    for first in range(len(hydrogens)):
        text = record_of(without(whole, *hydrogens[first:]))
        read = Chem.MolFromMolBlock(text, removeHs=False)
        expected = {atom.GetIdx(): atom.GetTotalNumHs() for atom in read.GetAtoms()}
        assert missing_of(text) == {k: count for k, count in expected.items() if count}


def test_a_radical_lacks_none():
    assert missing_of(record_of(Chem.AddHs(Chem.MolFromSmiles("[CH2]CC")))) == {}


@pytest.fixture
def part():
    """C[C@H](N)CS with its hydrogens, but for that of carbon 2 and that of sulphur."""
    return without(embedded("C[C@H](N)CS"), 8, 13)


SAID = "2 missing hydrogens were added: 1 to C2, 1 to S5"


def test_those_that_are_missing_are_added_and_all_given_positions_stay(part):
    given = part.GetConformer().GetPositions()
    text = record(part, "part", ID="7").replace("$$$$\n", "")
    structure = pliant.read_text(text, "part.sdf")
    options = ConformerOptions()
    for subject in (
        subject_of(Record(3, text, "part"), options),
        subject_of_mol(part, options),
        subject_of_structure(structure, options),
    ):
        assert subject.warnings == [SAID]
        assert subject.structure.positions[:12] == pytest.approx(given, abs=5e-5)
        assert Chem.MolToSmiles(Chem.RemoveHs(subject.molecule)) == "C[C@H](N)CS"
        added = subject.structure.positions[12:]
        apart = np.linalg.norm(added - subject.structure.positions[[1, 4]], axis=1)
        assert apart == pytest.approx([1.1, 1.34], abs=0.05)
    record_made = subject_of(Record(3, text, "part"), options).block
    assert record_made.title == "part"
    assert record_made.items == "> <ID>\n7\n\n"
    with pytest.warns(pliant.PliantWarning, match=f"^part: {SAID}$"):
        assert pliant.conformers(part, 2, **FAST).GetNumAtoms() == 14


def test_those_of_the_largest_molecule_have_their_numbers_in_the_record(part):
    several = Chem.CombineMols(embedded("O"), part)
    Chem.SanitizeMol(several)
    said = ["2 missing hydrogens were added: 1 to C5, 1 to S8"]
    text = record(several, "both").replace("$$$$\n", "")
    assert subject_of(Record(1, text, ""), ConformerOptions()).warnings == said
    assert subject_of_mol(several, ConformerOptions()).warnings == said


def test_many_are_counted():
    whole = embedded("CCCCCCCCCCO")
    polar = without(whole, *range(11, 32))
    assert subject_of_mol(polar, ConformerOptions()).warnings == [
        "21 missing hydrogens were added: 3 to C1, 2 to C2, 2 to C3, 2 to C4, 2 to C5, 2 to C6, 2 "
        "to C7, 2 to C8, and to 2 more atoms"
    ]
