# SPDX-License-Identifier: MIT
"""PDB, mmCIF and XYZ files of one ligand: bond orders as stated, from hydrogens, or by a SMILES."""

import re

import numpy as np
import pytest
from real_files import DIPEPTIDE

import pliant

pytest.importorskip("rdkit")
from libraries import embedded
from pliant.jobs.conformers.options import ConformerOptions
from pliant.jobs.conformers.records import read_records
from pliant.jobs.conformers.subject import subject_of
from rdkit import Chem

FAST = {"max": 2, "frames": 10, "starts": 1}
#: of acids, salts, nitro groups, sulphur, phosphorus, rings, triple bonds, E and Z, R and S
SMILES = (
    "CC(=O)Oc1ccccc1C(=O)O",
    "C[C@H]([NH3+])C(=O)[O-]",
    "OC(=O)/C=C/C#N",
    "CC(=O)/C=C\\C",
    "O=[N+]([O-])c1ccccc1",
    "CC[S@](C)=O",
    "COP(=O)([O-])OC",
    "C[n+]1ccccc1",
    "Cn1cnc2c1c(=O)n(C)c(=O)n2C",
    "[C-]#[N+]C",
)
GUESSED = (
    "bond orders and the formal charge {} were guessed by RDKit from the hydrogens; "
    "pliant conformers FILE --smiles TEXT states them"
)


ORDERS_GUESSED = GUESSED.replace(" and the formal charge {}", "")


def canonical(molecule):
    return Chem.MolToSmiles(Chem.RemoveHs(molecule))


def written(molecule, path, *, orders=True):
    """The file of a molecule; orders are told by doubled CONECT, or chem_comp_bond."""
    if path.suffix == ".xyz":
        path.write_text(Chem.MolToXYZBlock(molecule))
    elif path.suffix == ".pdb":
        path.write_text(Chem.MolToPDBBlock(molecule, flavor=0 if orders else 8))
    else:
        _write_mmcif(molecule, path, orders)
    return path


def _write_mmcif(molecule, path, orders):
    gemmi = pytest.importorskip("gemmi")
    structure = gemmi.read_pdb_string(Chem.MolToPDBBlock(molecule))
    structure.setup_entities()
    document = structure.make_mmcif_document()
    names = [atom.name for atom in structure[0][0][0]]
    if orders:
        tags = ["comp_id", "atom_id_1", "atom_id_2", "value_order"]
        loop = document.sole_block().init_loop("_chem_comp_bond.", tags)
        drawn = Chem.Mol(molecule)
        Chem.Kekulize(drawn, clearAromaticFlags=True)
        for bond in drawn.GetBonds():
            a, b = names[bond.GetBeginAtomIdx()], names[bond.GetEndAtomIdx()]
            loop.add_row(["UNL", a, b, bond.GetBondType().name[:4]])
    document.write_file(str(path))


def subject(path, smiles=None, **more):
    return subject_of(next(read_records(path)), ConformerOptions("--", smiles=smiles, **more))


def refused(path, smiles=None, **more):
    with pytest.raises(pliant.InputError) as caught:
        subject(path, smiles, **more)
    return str(caught.value).removeprefix(f"{path.name} record 1: ")


@pytest.fixture
def alanine():
    return embedded("C[C@H](N)C(=O)O")


@pytest.mark.parametrize("smiles", SMILES)
def test_a_ligand_is_the_molecule_that_was_written(smiles, tmp_path):
    whole = embedded(smiles)
    bare = Chem.RemoveHs(whole)
    expected, charge = canonical(whole), Chem.GetFormalCharge(whole)
    guessed = GUESSED.format(f"{charge:+d}" if charge else "0")
    for name in ("x.pdb", "x.cif"):
        made = subject(written(whole, tmp_path / name))
        assert canonical(made.molecule) == expected, name
        assert made.warnings == []
    for name in ("x.pdb", "x.cif", "x.xyz"):
        path = written(whole, tmp_path / name, orders=False)
        made = subject(path)
        assert canonical(made.molecule) == expected, name
        assert made.structure.positions == pytest.approx(pliant.read(path).positions)
        has_charges = name != "x.xyz" and any(atom.GetFormalCharge() for atom in whole.GetAtoms())
        assert made.warnings == [ORDERS_GUESSED if has_charges else guessed]
        assert canonical(subject(path, smiles).molecule) == expected
        path = written(bare, tmp_path / name, orders=False)
        made = subject(path, smiles)
        assert canonical(made.molecule) == expected, f"{name} without hydrogens"
        assert made.warnings == []
        assert made.structure.positions[: len(bare.GetAtoms())] == pytest.approx(
            pliant.read(path).positions
        )


@pytest.mark.parametrize("name", ["x.pdb", "x.cif", "x.xyz"])
def test_conformers_of_a_file(name, alanine, tmp_path):
    path = written(alanine, tmp_path / name, orders=False)
    with pytest.warns(pliant.PliantWarning, match="were guessed by RDKit"):
        (guessed,) = pliant.conformers(path, **FAST)
    (stated,) = pliant.conformers(path, smiles="C[C@H](N)C(=O)O", **FAST)
    for found in (guessed, stated):
        assert found.name == "x"
        assert len(found) == 2
        assert canonical(found.to_rdkit()) == "C[C@H](N)C(=O)O"
    of_structure = pliant.conformers(pliant.read(path), smiles="CC(N)C(=O)O", **FAST)
    assert np.array_equal(of_structure.positions, stated.positions)


def test_charges_follow_from_stated_orders(tmp_path):
    path = written(embedded("C[C@H]([NH3+])C(=O)[O-]"), tmp_path / "x.pdb")
    path.write_text(re.sub(r"(?m)^(HETATM.{72}).*", r"\1", path.read_text()))
    made = subject(path)
    assert made.warnings == ["formal charges follow from numbers of bonds: +1 of N1, -1 of O2"]
    assert canonical(made.molecule) == "C[C@H]([NH3+])C(=O)[O-]"


def test_hydrogens_are_added_where_charges_follow_from_orders(tmp_path):
    part = Chem.RWMol(embedded("C[C@H]([NH3+])C(=O)NC"))
    part.RemoveAtom(16)
    part.RemoveAtom(14)
    path = written(part.GetMol(), tmp_path / "x.pdb")
    path.write_text(re.sub(r"(?m)^(HETATM.{72}).*", r"\1", path.read_text()))
    made = subject(path)
    assert made.warnings == [
        "formal charges follow from numbers of bonds: +1 of N1",
        "2 missing hydrogens were added: 1 to N2, 1 to C4",
    ]
    assert canonical(made.molecule) == "CNC(=O)[C@H](C)[NH3+]"


def test_bytes_that_are_not_utf8_are_no_fault(alanine, tmp_path):
    path = written(alanine, tmp_path / "x.pdb")
    path.write_bytes(b"REMARK     caf\xe9\n" + path.read_bytes())
    assert canonical(subject(path).molecule) == "C[C@H](N)C(=O)O"
    (tmp_path / "x.sdf").write_bytes(b"caf\xe9" + Chem.MolToMolBlock(alanine).encode())
    (found,) = pliant.conformers(tmp_path / "x.sdf", **FAST)
    assert found.name == "caf\udce9"


def test_without_hydrogens_a_smiles_is_asked_for(alanine, tmp_path):
    bare = Chem.RemoveHs(alanine)
    assert refused(written(bare, tmp_path / "x.pdb", orders=False)) == (
        "the ligand has no hydrogens, and its bond orders are not known: "
        "pliant conformers FILE --smiles TEXT gives both"
    )
    assert refused(written(bare, tmp_path / "x.pdb")) == (
        "the molecule is without its hydrogens: pliant conformers FILE --smiles TEXT gives them"
    )
    path = written(bare, tmp_path / "x.xyz")
    (failed,) = pliant.conformers(path, **FAST)
    assert failed.reason == (
        "x.xyz record 1: the ligand has no hydrogens, and its bond orders are not known: "
        "smiles=TEXT gives both"
    )


@pytest.mark.parametrize("smiles", ["C[C@H](N)C(=O)O", "Oc1ccccc1", "C1CCCCC1", "CC(C)=O"])
def test_a_hydrogen_that_carbon_lacks_is_no_other_molecule(smiles, tmp_path):
    whole = embedded(smiles)
    at = [k for k, atom in enumerate(whole.GetAtoms()) if atom.GetAtomicNum() == 1]
    on_carbon = [k for k in at if whole.GetAtomWithIdx(k).GetNeighbors()[0].GetAtomicNum() == 6]
    for lacking in ([on_carbon[0]], on_carbon):
        part = Chem.RWMol(whole)
        for k in sorted(lacking, reverse=True):
            part.RemoveAtom(k)
        path = written(part.GetMol(), tmp_path / "x.xyz")
        assert refused(path) in (
            "RDKit finds no bond orders with any formal charge: are all hydrogens there? "
            "pliant conformers FILE --smiles TEXT gives both",
            "the ligand has no hydrogens, and its bond orders are not known: "
            "pliant conformers FILE --smiles TEXT gives both",
        )
        assert canonical(subject(path, smiles).molecule) == smiles


@pytest.mark.parametrize(
    ("smiles", "what"),
    [
        ("CCC(=O)O", "expected C3 O2 without hydrogens, found C3 N1 O2"),
        ("C1C(N)C(=O)O1", "expected 6 bonds without hydrogens, found 5"),
        ("NCCC(=O)O", "other atoms are bonded to each other"),
        ("C[C@H](N)C(=O)[O-]", "expected 0 hydrogens at O2, found 1"),
        (
            "C[C@@H](N)C(=O)O",
            "expected R at C2, found S (without stereo in the SMILES, the file's is kept)",
        ),
    ],
)
def test_the_smiles_of_another_molecule_is_refused(smiles, what, alanine, tmp_path):
    path = written(alanine, tmp_path / "x.pdb")
    assert refused(path, smiles) == f"is not '{smiles}': {what}"


def test_the_smiles_of_the_other_double_bond_is_refused(tmp_path):
    path = written(Chem.RemoveHs(embedded("OC(=O)/C=C/CF")), tmp_path / "x.pdb", orders=False)
    assert refused(path, "OC(=O)/C=C\\CF") == (
        "is not 'OC(=O)/C=C\\\\CF': expected Z at C2=C3, found E "
        "(without stereo in the SMILES, the file's is kept)"
    )
    assert canonical(subject(path, "OC(=O)C=CCF").molecule) == "O=C(O)/C=C/CF"


def test_the_largest_molecule_of_a_file_is_kept(alanine, tmp_path):
    both = Chem.CombineMols(
        alanine, Chem.MolFromPDBBlock("HETATM    1 NA    NA A   9       9.000   9.000   9.000\n")
    )
    path = written(both, tmp_path / "x.pdb")
    made = subject(path)
    assert made.notes[-1] == "the largest of 2 molecules is kept"
    assert canonical(made.molecule) == "C[C@H](N)C(=O)O"


@pytest.mark.parametrize("name", ["x.pdb", "x.xyz"])
def test_models_that_are_not_used_are_told(name, alanine, tmp_path):
    path = written(alanine, tmp_path / name, orders=False)
    text = path.read_text().replace("END\n", "")
    if name == "x.pdb":
        text = f"MODEL        1\n{text}ENDMDL\nMODEL        2\n{text}ENDMDL\nEND\n"
    path.write_text(text if name == "x.pdb" else text + text)
    assert subject(path).warnings == ["the first of 2 models is used", GUESSED.format(0)]


def test_a_protein_is_for_sample(tmp_path):
    line = [f"C {1.54 * k} 0 0" for k in range(501)]
    (tmp_path / "x.xyz").write_text("\n".join(["501", "", *line]))
    assert refused(tmp_path / "x.xyz") == (
        "expected one ligand of at most 500 atoms, found a molecule of 501; pliant sample takes "
        "proteins"
    )


def test_atoms_without_bonds_are_no_ligand(tmp_path):
    (tmp_path / "x.xyz").write_text("2\n\nC 0 0 0\nC 3.8 0 0\n")
    assert refused(tmp_path / "x.xyz") == "expected one ligand, found atoms without any bond"


def test_a_metal_has_no_bond_orders(tmp_path):
    atom = "HETATM{:5d} {:<4} LIG A   1    {:8.3f}   0.000   0.000  1.00  0.00          {:>2}\n"
    atoms = [(1, "ZN", 0, "ZN"), (2, "C1", 1.95, "C"), (3, "C2", -1.95, "C")]
    lines = [*(atom.format(*one) for one in atoms), "CONECT    1    2    3\n"]
    (tmp_path / "x.pdb").write_text("".join(lines))
    assert refused(tmp_path / "x.pdb") == "RDKit finds no bond orders at the metal Zn"


def test_a_ligand_is_taken_out_of_a_complex(alanine, tmp_path):
    alone = written(alanine, tmp_path / "x.pdb")
    (expected,) = pliant.conformers(alone, **FAST)
    beside = [line for line in DIPEPTIDE.read_text().splitlines() if line.startswith("ATOM")]
    ligand = [line for line in alone.read_text().splitlines() if not line.startswith("END")]
    moved = [
        f"ATOM  {900 + int(line[6:11]):5d}{line[11:30]}{float(line[30:38]) + 50:8.3f}{line[38:]}"
        for line in beside
    ]
    both = tmp_path / "complex.pdb"
    both.write_text("\n".join([*ligand, *moved, "END", ""]))
    (found,) = pliant.conformers(both, select="resname UNL", **FAST)
    assert np.array_equal(found.positions, expected.positions)
    of_structure = pliant.conformers(pliant.read(both), select="resname UNL", **FAST)
    assert np.array_equal(of_structure.positions, expected.positions)
    (other,) = pliant.conformers(both, select="not resname UNL", **FAST)
    assert len(other.structure) == len(beside)


def test_a_peptide_is_prepared_as_everywhere(tmp_path):
    heavy = [line for line in DIPEPTIDE.read_text().splitlines() if line[76:78] != " H"]
    path = tmp_path / "x.pdb"
    path.write_text("\n".join([*heavy, ""]))
    (failed,) = pliant.conformers(path, **FAST)
    assert "without its hydrogens" in failed.reason
    (made,) = pliant.conformers(path, all_hydrogens=True, **FAST)
    whole = pliant.prepare(path, all_hydrogens=True).structure
    expected = pliant.conformers(whole, **FAST)
    assert np.array_equal(made.positions, expected.positions)
    assert (made.structure.elements == 1).sum() == 12


def test_another_frame_of_a_file_is_taken(tmp_path):
    frames = [embedded("CCO", seed) for seed in (1, 2)]
    path = tmp_path / "x.xyz"
    path.write_text("".join(map(Chem.MolToXYZBlock, frames)))
    made = subject(path, "CCO", frame=2)
    assert made.warnings == []
    assert made.structure.positions == pytest.approx(pliant.read(path, 2).positions)


@pytest.mark.parametrize("molecule", ["CCO", Chem.MolFromSmiles("CCO"), "lost.sdf"])
@pytest.mark.parametrize("given", [{"select": "name C1"}, {"smiles": "CC"}], ids=str)
def test_what_only_a_ligand_has_is_refused_before_anything_is_read(molecule, given):
    with pytest.raises(pliant.OptionError) as error:
        pliant.conformers(molecule, **given)
    (name,) = given
    assert str(error.value) == (
        f"{name}: goes with a PDB, mmCIF or XYZ file of one ligand, or a Structure"
    )


def test_what_holds_only_in_a_protein_is_no_argument(alanine):
    with pytest.raises(TypeError, match="conformers: has no argument 'hbond_cutoff'"):
        pliant.conformers(alanine, hbond_cutoff=-2)
    with pytest.raises(pliant.OptionError) as error:
        pliant.conformers(pliant.read(DIPEPTIDE), assembly=1)
    assert str(error.value) == "assembly: goes with the path of a file of a molecule"
