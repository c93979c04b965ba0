# SPDX-License-Identifier: MIT
"""Records are written as they were read, but for the positions: RDKit reads the same molecule."""

import numpy as np
import pytest

pytest.importorskip("rdkit")
from pliant.jobs.conformers.mol_block import block_of, filled, one_line, parse
from pliant.jobs.conformers.v3000 import fits_v2000, text_of
from rdkit import Chem
from rdkit.Chem import AllChem

import pliant

SALT = "C/C=C/[C@H](F)[13CH2]C(=O)[O-].[Na+].C[C@@H](O)[CH2]"
WRITERS = {"V2000": Chem.MolToMolBlock, "V3000": Chem.MolToV3KMolBlock}


@pytest.fixture(params=WRITERS)
def written(request):
    made = Chem.AddHs(Chem.MolFromSmiles(SALT))
    AllChem.EmbedMolecule(made, randomSeed=1)
    items = "> <a>\n50%\n\n>  <pliant_energy> (1)\n3\n\n> 25 <two lines>\nx\ny\n\n"
    return made, WRITERS[request.param](made) + items


def read(text):
    return Chem.MolFromMolBlock(text, removeHs=False)


def test_all_but_positions_is_kept(written):
    made, text = written
    moved = made.GetConformer().GetPositions() + 1.0
    back = read(filled(parse(text).form(), moved))
    assert Chem.MolToSmiles(back) == Chem.MolToSmiles(read(text))
    assert back.GetConformer().GetPositions() == pytest.approx(moved, abs=6e-5)
    assert parse(filled(parse(text).form(), moved)).form() == parse(text).form()


def test_components_and_the_record_of_one(written):
    made, text = written
    block = parse(text)
    parts = block.components()
    assert [tuple(part) for part in parts] == [tuple(x) for x in Chem.GetMolFrags(made)]
    assert [sorted(block.part(part).radicals) for part in parts] == [[], [], [3]]
    positions = made.GetConformer().GetPositions()
    for part, expected in zip(parts, Chem.GetMolFrags(made, asMols=True), strict=True):
        back = read(filled(block.part(part).form(), positions[part]))
        for one in (back, expected):
            Chem.AssignStereochemistryFrom3D(one)
        assert Chem.MolToSmiles(back) == Chem.MolToSmiles(expected)


def test_data_items_are_kept_but_ours(written):
    block = parse(written[1])
    assert block.items == "> <a>\n50%\n\n> 25 <two lines>\nx\ny\n\n"
    assert block.tags() == [("a", "50%"), ("two lines", "x\ny")]


def test_numbers_of_v3000_may_be_any_and_lines_may_go_on():
    lines = [
        *("water", "", "", "  0  0  0     0  0            999 V3000", "M  V30 BEGIN CTAB"),
        *("M  V30 COUNTS 3 2 0 0 0", "M  V30 BEGIN ATOM", "M  V30 17 O 0.0 0.0 -"),
        *("M  V30 0.119 0 CHG=0", "M  V30 4 H 0.0 0.763 -0.477 0"),
        *("M  V30 9 H 0.0 -0.763 -0.477 0", "M  V30 END ATOM", "M  V30 BEGIN BOND"),
        *("M  V30 1 1 17 4", "M  V30 2 1 17 9", "M  V30 END BOND", "M  V30 END CTAB", "M  END"),
    ]
    block = parse("\n".join(lines) + "\n")
    assert block.bonds == [(0, 1), (0, 2)]
    text = filled(block.form(), np.zeros((3, 3)))
    assert "M  V30 17 O 0.0000 0.0000 0.0000 0 CHG=0\n" in text
    assert Chem.MolToSmiles(Chem.MolFromMolBlock(text)) == "O"


def masses_of(made):
    """Of the elements, whatever the isotopes."""
    table = Chem.GetPeriodicTable()
    return np.array([table.GetAtomicWeight(atom.GetAtomicNum()) for atom in made.GetAtoms()])


@pytest.mark.parametrize("place", [-15355.0, 1e5, 9.9e8])
def test_far_from_the_origin_rdkit_reads_the_same_molecule(written, place):
    made, text = written
    far = made.GetConformer().GetPositions() + np.array([0.0, place, 0.0])
    far_text = text_of(parse(text), far, masses_of(made))
    assert "V3000" in far_text
    back = read(far_text)
    assert Chem.MolToSmiles(back) == Chem.MolToSmiles(read(text))
    assert back.GetConformer().GetPositions() == pytest.approx(far, abs=6e-5, rel=0)
    assert parse(far_text).radicals == parse(text).radicals


@pytest.mark.parametrize(
    ("z", "fits"), [(-9999.9999, True), (-10000.0, False), (99999.9999, True), (1e5, False)]
)
def test_the_columns_of_v2000(z, fits):
    text = Chem.MolToMolBlock(Chem.MolFromSmiles("[Na+]"))
    x = np.array([[0.0, 0.0, z]])
    assert fits_v2000(parse(text), x) == fits
    assert len(filled(parse(text).form(), x).splitlines()[4].split("Na")[0]) == 31 + (not fits)


def said_of(text):
    """Of each atom and bond, as RDKit reads it."""
    made = Chem.MolFromMolBlock(text, sanitize=False, removeHs=False)
    atoms = [
        (
            *(atom.GetSymbol(), atom.GetIsotope(), atom.GetFormalCharge(), atom.GetAtomMapNum()),
            *(atom.GetNumRadicalElectrons(), atom.GetNoImplicit()),
        )
        for atom in made.GetAtoms()
    ]
    bonds = [(bond.GetBondType(), bond.GetBondDir()) for bond in made.GetBonds()]
    return atoms, bonds, made.GetProp("_MolFileChiralFlag")


@pytest.mark.parametrize(
    "more", ["", "M  CHG  1   1  -2\n", "M  ISO  1   1  14\n", "M  RAD  1   1   3\n"]
)
def test_what_atom_and_bond_lines_say_is_in_v3000(more):
    atom = "    0.0000    0.0000    0.0000 {:3} {}{:3}  0  0  0{:3}  0  0  0{:3}  0  0"
    atoms = [("C", 1, 0, 0, 5), ("N", 0, 3, 0, 0), ("O", 0, 5, 0, 0), ("C", 0, 0, 15, 0)]
    head = "\n\n\n  4  2  0  0  1  0            999 V2000"
    bonds = ["  1  2  1  6", "  2  3  2  0"]
    text = "\n".join([head, *(atom.format(*one) for one in atoms), *bonds, f"{more}M  END\n"])
    far_text = text_of(
        parse(text), np.full((4, 3), 2e5), np.array([12.011, 14.007, 15.999, 12.011])
    )
    assert "V3000" in far_text
    assert said_of(far_text) == said_of(text)


def test_a_radical_of_an_atom_line_is_one():
    """RDKit knows radicals of M  RAD alone."""
    text = Chem.MolToMolBlock(Chem.MolFromSmiles("[Na]")).replace("Na  0  0", "Na  0  4")
    far_text = text_of(parse(text), np.full((1, 3), 2e5), np.array([22.99]))
    assert " 0 RAD=2 VAL=-1\n" in far_text


def test_groups_of_atoms_are_not_lost_without_a_word():
    text = Chem.MolToMolBlock(Chem.MolFromSmiles("[Na+]"))
    block = parse(text.replace("M  END", "M  STY  1   1 DAT\nM  END"))
    with pytest.raises(pliant.InputError) as caught:
        text_of(block, np.full((1, 3), 2e5), np.array([22.99]))
    assert str(caught.value) == (
        "the molecule does not fit the columns of V2000, and its lines 'M  STY' have no place in "
        "V3000"
    )


@pytest.mark.parametrize("atoms", [999, 1000])
def test_a_structure_of_any_number_of_atoms_has_a_record(atoms):
    made = Chem.MolFromSmiles(".".join(atoms * ["[Na+]"]))
    made.AddConformer(Chem.Conformer(atoms))
    made.GetConformer().SetPositions(5.0 * np.arange(3.0 * atoms).reshape(-1, 3))
    structure = pliant.from_rdkit(made)
    text = text_of(block_of(structure), structure.positions, structure.masses)
    back = read(text)
    assert ("V3000" in text) == (atoms > 999)
    assert back.GetNumAtoms() == Chem.GetFormalCharge(back) == atoms


@pytest.mark.parametrize(
    ("name", "line"),
    [
        ("$$$$", "$$$ $"),
        ("a$$$$$$$$b", "a$$$ $$$ $$b"),
        ("a\nb\r\x1b[31m", "a b  [31m"),
        ("β-carotene $$$", "β-carotene $$$"),
    ],
)
def test_a_title_is_one_line_that_ends_no_record(name, line):
    assert one_line(name) == line
    made = Chem.AddHs(Chem.MolFromSmiles("C"))
    AllChem.EmbedMolecule(made, randomSeed=1)
    for key in ("_Name", "_MolFileInfo", "_MolFileComments"):
        made.SetProp(key, name)
    found = pliant.conformers(pliant.from_rdkit(made), 1, frames=1, starts=1)
    assert found.sdf.splitlines()[0] == line
    again = pliant.conformers(made, 1, frames=1, starts=1)
    assert again.GetNumConformers() == 1
    assert again.GetProp("_Name") == name


def test_a_structure_has_a_record():
    structure = pliant.from_smiles("C[NH2+]CC(=O)[O-]")
    back = read(filled(block_of(structure).form(), structure.positions))
    assert Chem.MolToSmiles(Chem.RemoveHs(back)) == "C[NH2+]CC(=O)[O-]"
