# SPDX-License-Identifier: MIT
"""pliant sample of small molecules: what is reported, and SDF files of conformers read by RDKit."""

import json

import numpy as np
import pytest
from h5md_contents import contents

pytest.importorskip("rdkit")
from rdkit import Chem
from rdkit.Chem import AllChem, rdMolTransforms

#: frames as they are drawn; without it an SDF is made by pliant conformers
RAW = ("--sampler", "torsions")


@pytest.fixture
def drug(tmp_path):
    made = Chem.AddHs(Chem.MolFromSmiles("CCC(=O)N(c1ccccc1)C1CC[NH+](CCc2ccccc2)CC1"))
    AllChem.EmbedMolecule(made, randomSeed=7)
    Chem.MolToMolFile(made, str(tmp_path / "drug.sdf"))
    return "drug.sdf"


def records(path):
    return list(Chem.SDMolSupplier(str(path), removeHs=False))


def test_conformers_are_records_of_sdf(pliant, drug, tmp_path):
    ended = pliant("sample", drug, "-o", "conformers.sdf", *RAW, "--frames", 7, "--verbose")
    assert ended.code == 0
    assert "rotors          6: " in ended.out
    assert "rings           1: " in ended.out
    assert "amides          1: C(3) - N(5) cis or trans" in ended.out
    assert "how often is not claimed" in ended.out
    assert not (tmp_path / "conformers.pdb").exists()
    start = records(tmp_path / drug)[0]
    made = records(tmp_path / "conformers.sdf")
    assert [int(m.GetProp("frame")) for m in made] == list(range(7))
    for conformer in made:
        assert Chem.MolToSmiles(conformer) == Chem.MolToSmiles(start)


def test_sdf_and_h5md_have_the_same_conformers(pliant, drug, tmp_path):
    pliant("sample", drug, "-o", "one.sdf", "--frames", 3, *RAW)
    pliant("sample", drug, "-o", "one.h5md", "--frames", 3)
    stored = contents(tmp_path / "one.h5md")["particles/trajectory/position/value"]
    for frame, conformer in zip(stored, records(tmp_path / "one.sdf"), strict=True):
        assert conformer.GetConformer().GetPositions() == pytest.approx(frame, abs=6e-5)


def test_large_molecules_are_written_as_v3000(pliant, tmp_path):
    made = Chem.AddHs(Chem.MolFromSmiles("C" * 340))
    conformer = Chem.Conformer(made.GetNumAtoms())
    positions = np.zeros((made.GetNumAtoms(), 3))
    along = np.arange(340)
    positions[:340] = np.stack([1.27 * along, 0.43 * (-1.0) ** along, 0.0 * along], axis=1)
    for k, atom in enumerate(made.GetAtoms()):
        if atom.GetAtomicNum() == 1:
            (parent,) = (other.GetIdx() for other in atom.GetNeighbors())
            positions[k] = positions[parent] + [0.3 * (k % 3 - 1), 0.4, 0.9 * (-1) ** k]
    conformer.SetPositions(positions)
    made.AddConformer(conformer)
    Chem.MolToMolFile(made, str(tmp_path / "long.sdf"), forceV3000=True)
    ended = pliant(
        *"sample long.sdf -o out.sdf --frames 1 --model bonds --sampler torsions".split()
    )
    assert ended.code in (0, 3), ended.err
    if ended.code == 0:
        (read,) = records(tmp_path / "out.sdf")
        assert read.GetNumAtoms() == made.GetNumAtoms()
        assert read.GetNumBonds() == made.GetNumBonds()


def test_what_does_not_fit_the_columns_of_v2000_is_written_as_v3000(pliant, tmp_path):
    """-15355.1850 has eleven characters; a title of "$$$$" would end the record."""
    made = Chem.AddHs(Chem.MolFromSmiles("CCCC"))
    AllChem.EmbedMolecule(made, randomSeed=7)
    moved = made.GetConformer().GetPositions() + np.array((0, 0, -15355))
    lines = Chem.MolToMolBlock(made).split("\n")
    rows = [f"{x:10.4f}{y:10.4f}{z:10.3f}" for x, y, z in moved]
    lines[4:18] = [row + line[30:] for row, line in zip(rows, lines[4:18], strict=True)]
    (tmp_path / "far.sdf").write_text("\n".join(["a $$$$", *lines[1:]]))
    assert pliant("sample", "far.sdf", "-o", "out.sdf", *RAW, "--frames", 2).code == 0
    first = (tmp_path / "out.sdf").read_text().split("$$$$\n")[0].split("\n")
    assert (first[0], first[3][34:39]) == ("a $$$ $", "V3000")
    for one in records(tmp_path / "out.sdf"):
        assert Chem.MolToSmiles(Chem.RemoveHs(one)) == "CCCC"
        found = one.GetConformer().GetPositions()
        assert abs(found.mean(axis=0) - moved.mean(axis=0)).max() < 3


def test_what_moves_is_named_in_json(pliant, drug):
    ended = pliant("sample", drug, "-o", "out.sdf", *RAW, "--frames", 2, "--json")
    report = json.loads(ended.out)
    assert report["sampler"] == "torsions"
    assert len(report["rotors"]) == 6
    assert len(report["rings"]) == 1
    assert report["amides"] == ["C(3) - N(5)"]
    assert report["loop_units"] == 0


@pytest.mark.parametrize(
    ("smiles", "held"),
    [
        ("OC(=O)c1cccc(C)c1-c1c(C)cccc1CO", 1),  # four atoms beside the bond
        ("Oc1ccc2ccccc2c1-c1c(O)ccc2ccccc12", 1),  # BINOL
        ("Cc1ccccc1-c1ccccc1C", 0),  # two: it turns
    ],
)
def test_atropisomers_are_named_and_keep_their_handedness(pliant, tmp_path, smiles, held):
    made = Chem.AddHs(Chem.MolFromSmiles(smiles))
    AllChem.EmbedMolecule(made, randomSeed=7)
    Chem.MolToMolFile(made, str(tmp_path / "biaryl.sdf"))
    ended = pliant("sample", "biaryl.sdf", "-o", "out.sdf", *RAW, "--frames", 60, "--json")
    assert len(json.loads(ended.out)["atropisomers"]) == held
    aryls = Chem.MolFromSmarts("c:c-c:c")
    (at,) = {
        hit[1:3]: hit for hit in made.GetSubstructMatches(aryls) if not in_ring(made, hit)
    }.values()
    angles = [
        rdMolTransforms.GetDihedralDeg(one.GetConformer(), *at)
        for one in [made, *records(tmp_path / "out.sdf")]
    ]
    assert (min(angles) * max(angles) > 0) == (held == 1)


def in_ring(molecule, hit):
    return molecule.GetBondBetweenAtoms(hit[1], hit[2]).IsInRing()


def named(pliant, tmp_path, smiles):
    made = Chem.AddHs(Chem.MolFromSmiles(smiles))
    AllChem.EmbedMolecule(made, randomSeed=7)
    Chem.MolToMolFile(made, str(tmp_path / "rings.sdf"))
    ended = pliant(
        "sample", "rings.sdf", "-o", "out.sdf", *RAW, "--frames", 2, "--json", "--overwrite"
    )
    return json.loads(ended.out)


def test_rings_are_named_by_what_they_can_do(pliant, tmp_path):
    fused = named(pliant, tmp_path, "C1CC[C@H]2CCCC[C@H]2C1")
    assert [one.count("C(") for one in fused["rings"]] == [10]
    assert fused["rigid_rings"] == []
    bridged = named(pliant, tmp_path, "C1CC2CCC1C2")
    assert bridged["rings"] == []
    assert bridged["rigid_rings"] == ["C(1) C(2) C(3) C(4) C(5) C(6) C(7)"]
    seven = named(pliant, tmp_path, "O=C1CN=Cc2ccccc2N1")
    assert seven["rings"] == []
    assert [one.count("(") for one in seven["rigid_rings"]] == [11]
    large = named(pliant, tmp_path, "C1CCCCCCCCC1")
    assert large["rings"] == large["rigid_rings"] == []
    assert large["loop_units"] > 0
    again = ("--overwrite", "--verbose")
    table = pliant("sample", "rings.sdf", "-o", "out.sdf", *RAW, "--frames", 2, *again).out
    assert "rigid units, drawn and closed" in table


def test_sdf_takes_no_options_of_h5md(pliant, drug):
    ended = pliant("sample", drug, "-o", "out.sdf", *RAW, "--precision", 0.01)
    assert ended.code == 2
    assert "--precision: goes with H5MD, not with the SDF file out.sdf" in ended.err


def test_what_cannot_turn_is_reported(pliant, tmp_path):
    made = Chem.AddHs(Chem.MolFromSmiles("Cn1cnc2c1c(=O)n(C)c(=O)n2C"))
    AllChem.EmbedMolecule(made, randomSeed=7)
    Chem.MolToMolFile(made, str(tmp_path / "caffeine.sdf"))
    ended = pliant("sample", "caffeine.sdf", "-o", "out.sdf", *RAW, "--frames", 2)
    assert ended.code == 0
    assert "warning: no bond can rotate and no ring has another form" in ended.err


@pytest.mark.parametrize("version", ["V2000", "V3000"])
def test_isotopes_radicals_charges_and_name_are_kept(pliant, tmp_path, version):
    smiles = "[13CH3]C([2H])([O])CC[NH3+]"
    made = Chem.AddHs(Chem.MolFromSmiles(smiles))
    AllChem.EmbedMolecule(made, randomSeed=3)
    made.SetProp("_Name", "labelled amine")
    block = Chem.MolToMolBlock(made) if version == "V2000" else Chem.MolToV3KMolBlock(made)
    (tmp_path / "in.sdf").write_text(block + "$$$$\n")
    ended = pliant("sample", tmp_path / "in.sdf", "--frames", "3", "-o", tmp_path / "out.sdf", *RAW)
    assert ended.code == 0, ended.err
    records = list(Chem.SDMolSupplier(str(tmp_path / "out.sdf"), removeHs=False))
    assert len(records) == 3
    for record in records:
        assert record.GetProp("_Name") == "labelled amine"
        for what in ("GetIsotope", "GetNumRadicalElectrons", "GetFormalCharge", "GetSymbol"):
            assert [getattr(atom, what)() for atom in record.GetAtoms()] == [
                getattr(atom, what)() for atom in made.GetAtoms()
            ], what
