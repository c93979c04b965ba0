# SPDX-License-Identifier: MIT
"""Records are written as they were read, but for the positions: RDKit reads the same molecule."""

import numpy as np
import pytest

pytest.importorskip("rdkit")
from pliant.conformers.mol_block import block_of, filled, parse
from rdkit import Chem
from rdkit.Chem import AllChem

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


def test_a_structure_has_a_record():
    import pliant

    structure = pliant.from_smiles("C[NH2+]CC(=O)[O-]")
    back = read(filled(block_of(structure).form(), structure.positions))
    assert Chem.MolToSmiles(Chem.RemoveHs(back)) == "C[NH2+]CC(=O)[O-]"
