# SPDX-License-Identifier: MIT
"""pliant conformers: the file of one ligand, alone and with a SMILES."""

import pytest

pytest.importorskip("rdkit")
from libraries import embedded
from rdkit import Chem

FAST = ("--frames", 40, "--starts", 2, "--max", 3)


def test_the_file_of_one_ligand(pliant, tmp_path):
    alanine = Chem.RemoveHs(embedded("C[C@H](N)C(=O)O"))
    (tmp_path / "ligand.pdb").write_text(Chem.MolToPDBBlock(alanine, flavor=8))
    ended = pliant("conformers", "ligand.pdb", *FAST)
    assert (ended.code, ended.out) == (1, "")
    assert ended.err == (
        "warning: record 1 (ligand): the ligand has no hydrogens, and its bond orders are not "
        "known: pliant conformers FILE --smiles TEXT gives both\n"
        "pliant conformers: error: no record gave a conformer\n"
    )
    ended = pliant("conformers", "ligand.pdb", "--smiles", "C[C@H](N)C(=O)O", *FAST)
    assert (ended.code, ended.err) == (0, "")
    made = list(Chem.SDMolSupplier(str(tmp_path / "ligand-conformers.sdf")))
    assert {Chem.MolToSmiles(one) for one in made} == {"C[C@H](N)C(=O)O"}
    assert {one.GetProp("_Name") for one in made} == {"ligand"}
