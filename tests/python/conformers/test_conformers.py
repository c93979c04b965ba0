# SPDX-License-Identifier: MIT
"""pliant.conformers: from and to RDKit, structures, libraries; failures are never lost."""

import numpy as np
import pytest

import pliant

pytest.importorskip("rdkit")
from libraries import embedded, library, record
from rdkit import Chem
from rdkit.Chem import AllChem, rdForceFieldHelpers

FAST = {"frames": 60, "starts": 2}


def test_a_mol_gives_a_mol_with_its_properties():
    made = embedded("CCC(=O)OCC")
    made.SetProp("pIC50", "7.1")
    made.SetProp("_Name", "ester")
    found = pliant.conformers(made, 5, energy="MMFF94s", **FAST)
    assert found.GetNumConformers() == 5
    assert (found.GetProp("pIC50"), found.GetProp("_Name")) == ("7.1", "ester")
    assert found.GetProp("pliant_energy_name").startswith("MMFF94s, RDKit ")
    assert Chem.MolToSmiles(found) == Chem.MolToSmiles(made)
    energies = [one.GetDoubleProp("pliant_energy") for one in found.GetConformers()]
    assert energies == sorted(energies)
    assert {one.GetIntProp("pliant_start") for one in found.GetConformers()} <= {1, 2}
    properties = rdForceFieldHelpers.MMFFGetMoleculeProperties(found, "MMFF94s")
    for one, energy in zip(found.GetConformers(), energies, strict=True):
        field = rdForceFieldHelpers.MMFFGetMoleculeForceField(found, properties, confId=one.GetId())
        assert field.CalcEnergy() == pytest.approx(energy)


def test_none_is_nearer_than_rms_or_above_the_window():
    found = pliant.conformers("CCCCCC", 50, rms=0.6, window=4.0, **FAST)
    energies = [one.GetDoubleProp("pliant_energy") for one in found.GetConformers()]
    assert len(energies) > 2
    assert max(energies) - min(energies) <= 4.0
    heavy = Chem.RemoveHs(found)
    ids = range(len(energies))
    order = list(range(6))  # atom by atom
    pairs = [(a, b) for a in ids for b in ids if a < b]
    same = list(zip(order, order, strict=True))
    for a, b in pairs:
        assert Chem.rdMolAlign.AlignMol(heavy, heavy, a, b, atomMap=same) >= 0.6 - 1e-6


def test_one_start_with_nothing_asked_for_has_the_frames_of_sample():
    structure = pliant.from_smiles("CC(C)C(=O)OCC")
    found = pliant.conformers(structure, 40, frames=40, starts=1, rms=0.0, energy="none")
    assert isinstance(found, pliant.Conformers)
    assert found.energies is None
    assert np.array_equal(found.positions, pliant.sample(structure, 40).positions)
    assert np.array_equal(found[3], found.trajectory[3])
    assert found.worst_bar < 1e-10


def test_minimised_conformers_say_so():
    found = pliant.conformers(
        pliant.from_smiles("CCCCO"), 3, energy="MMFF94s", minimise=True, **FAST
    )
    assert np.isnan(found.worst_bar)
    assert "> <pliant_lengths>\nminimised: lengths and angles are the force field's\n" in found.sdf
    assert "pliant_worst_bar" not in found.sdf
    raw = pliant.conformers(pliant.from_smiles("CCCCO"), 3, energy="MMFF94s", **FAST)
    assert found.energies.min() < raw.energies.min()


def test_uff_is_named_where_mmff_lacks_parameters():
    found = pliant.conformers(pliant.from_smiles("CC[Se]CC"), 2, **FAST)
    assert found.energy_name == "Pliant's own energy, kcal/mol"
    found = pliant.conformers(pliant.from_smiles("CC[Se]CC"), 2, minimise=True, **FAST)
    assert found.energy_name.startswith("UFF, as MMFF94s lacks parameters, RDKit ")
    with pytest.raises(pliant.InputError, match="MMFF94s of RDKit: parameters of an atom are miss"):
        pliant.conformers(pliant.from_smiles("CC[Se]CC"), 2, energy="MMFF94s", **FAST)


def test_energies_by_openmm(tmp_path):
    pytest.importorskip("openmm")
    path = tmp_path / "ethane.xml"
    atoms = "".join(f'<Atom name="C{k}" type="C"/>' for k in range(2))
    atoms += "".join(f'<Atom name="H{k}" type="H"/>' for k in range(6))
    bonds = '<Bond atomName1="C0" atomName2="C1"/>' + "".join(
        f'<Bond atomName1="C{k // 3}" atomName2="H{k}"/>' for k in range(6)
    )
    path.write_text(
        "<ForceField><AtomTypes>"
        '<Type name="C" class="C" element="C" mass="12"/>'
        '<Type name="H" class="H" element="H" mass="1"/></AtomTypes>'
        f'<Residues><Residue name="UNK">{atoms}{bonds}</Residue></Residues>'
        '<HarmonicBondForce><Bond class1="C" class2="C" length="0.16" k="100000"/>'
        '<Bond class1="C" class2="H" length="0.11" k="100000"/></HarmonicBondForce></ForceField>'
    )
    structure = pliant.read_text(record(embedded("CC"), "ethane"), "x.sdf")
    raw = pliant.conformers(structure, 1, energy=str(path), **FAST)
    assert raw.energy_name.startswith(f"{path}, OpenMM ")
    x, bonds = raw.positions[0], structure.bonds
    lengths = np.linalg.norm(x[bonds[:, 0]] - x[bonds[:, 1]], axis=1) / 10
    wanted = np.where(
        structure.elements[bonds].max(axis=1) == structure.elements[bonds].min(axis=1), 0.16, 0.11
    )
    assert raw.energies[0] == pytest.approx(np.sum(50000 * (lengths - wanted) ** 2) / 4.184)
    low = pliant.conformers(structure, 1, energy=str(path), minimise=True, **FAST)
    assert low.energies[0] == pytest.approx(0, abs=1e-3)
    with pytest.raises(pliant.InputError, match=r"ethane.xml: No template found"):
        pliant.conformers("CCO", 1, energy=str(path), **FAST)


def test_salts_are_said():
    salt = Chem.AddHs(Chem.MolFromSmiles("CCC(=O)[O-].[Na+].O"))
    AllChem.EmbedMolecule(salt, randomSeed=1)
    structure = pliant.read_text(Chem.MolToMolBlock(salt), "salt.sdf")
    for given in (structure, pliant.from_rdkit(salt)):
        found = pliant.conformers(given, 3, **FAST)
        assert len(found.structure) == 10
        assert found.notes[0] == "the largest of 3 molecules is kept"
        assert Chem.MolToSmiles(Chem.RemoveHs(found.to_rdkit())) == "CCC(=O)[O-]"
    assert pliant.conformers(salt, 3, **FAST).GetNumAtoms() == 10


@pytest.mark.parametrize(
    ("smiles", "what"),
    [
        (
            "[Fe+2].c1cc[cH-]c1.c1cc[cH-]c1",
            "the metal Fe is not bonded to the largest of 3 molecules: only lone ions of groups 1 "
            "and 2 are left out",
        ),
        (
            "CCCC(=O)[O-].C[Sn+](C)C",
            "the metal Sn is not bonded to the largest of 2 molecules: only lone ions of groups 1 "
            "and 2 are left out",
        ),
        ("N[Pt](N)(Cl)Cl", "RDKit makes no 3-D structure of the metal Pt"),
        ("CC*", "atom 3 is '*': expected an element"),
    ],
)
def test_metals_are_never_left_out_and_what_is_no_element_is_named(tmp_path, smiles, what):
    (tmp_path / "some.smi").write_text(f"{smiles} some\n")
    drawn = Chem.MolFromSmiles(smiles)
    AllChem.Compute2DCoords(drawn)
    (tmp_path / "some.sdf").write_text(record(drawn, "some"))
    for name in ("some.smi", "some.sdf"):
        (failed,) = pliant.conformers(tmp_path / name, 3, embed=True, **FAST)
        assert failed.name == "some"
        reason = failed.reason.replace("'R'", "'*'").replace("'R#'", "'*'")
        assert reason == f"{name} record 1: {what}"


@pytest.mark.parametrize("symbol", ["A", "Q", "*", "R#", "Xx"])
def test_symbols_that_are_no_element_are_named(tmp_path, symbol):
    text = record(embedded("CC"), "some").replace(" C   0", f" {symbol:<3} 0", 1)
    (tmp_path / "some.sdf").write_text(text)
    (failed,) = pliant.conformers(tmp_path / "some.sdf", 3, **FAST)
    assert failed.reason == f"some.sdf record 1: atom 1 is '{symbol}': expected an element"


def test_a_sample_of_a_salt_is_of_the_largest_molecule():
    salt = Chem.AddHs(Chem.MolFromSmiles("CCCC(=O)[O-].[Na+]"))
    AllChem.EmbedMolecule(salt, randomSeed=1)
    found = pliant.sample(pliant.read_text(Chem.MolToMolBlock(salt), "salt.sdf"), 3)
    assert len(found.structure) == 13


def test_drawings_and_molecules_without_hydrogens():
    drawn = Chem.MolFromSmiles("C[C@H](F)CO")
    AllChem.Compute2DCoords(drawn)
    bare = Chem.RemoveHs(embedded("C[C@H](F)CO"))
    for one, what in ((drawn, "a 2-D drawing"), (bare, "without its hydrogens")):
        with pytest.raises(pliant.InputError) as caught:
            pliant.conformers(one, 3, **FAST)
        assert str(caught.value) == (
            f"the molecule: the molecule is {what}: embed=True makes it 3-D, with hydrogens, by "
            "RDKit"
        )
        found = pliant.conformers(one, 3, embed=True, **FAST)
        assert found.GetNumAtoms() == 12
        assert Chem.MolToSmiles(Chem.RemoveHs(found)) == "C[C@H](F)CO"
    found = pliant.conformers(Chem.MolFromSmiles("C[C@H](F)CO"), 3, **FAST)
    assert found.GetNumAtoms() == 12


def test_no_candidate_is_an_error(monkeypatch):
    from pliant.jobs.conformers import core

    none = core.Drawn(np.zeros((0, 9, 3)), np.zeros(0, int), np.zeros(0), np.zeros((1, 9, 3)), 0.0)
    monkeypatch.setattr(core, "draw", lambda *_, **__: none)
    with pytest.raises(pliant.InputError, match=r"^none of 60 candidates is whole$"):
        pliant.conformers("CCO", 3, **FAST)


def test_a_path_gives_an_iterator_that_loses_nothing(tmp_path):
    path = tmp_path / "library.sdf"
    path.write_text(library(2) + "broken\n\n\nno counts\n$$$$\n" + library(1))
    with pytest.warns(pliant.PliantWarning) as told:
        found = list(pliant.conformers(path, 2, **FAST))
    assert [str(one.message) for one in told] == [
        "library.sdf record 4 (molecule 1): the same molecule as library.sdf record 1 (molecule "
        "1): done again"
    ]
    assert [one.number for one in found] == [1, 2, 3, 4]
    assert [one.name for one in found] == ["molecule 1", "molecule 2", "broken", "molecule 1"]
    assert [len(one) for one in found] == [2, 2, 0, 2]
    assert not found[2]
    assert found[2].reason == (
        'library.sdf record 3:4: "no counts" is not a counts line (atoms and bonds in columns 1-3 '
        "and 4-6)"
    )
    assert found[1].to_rdkit().GetProp("note") == "two\nlines"
    assert np.array_equal(found[0].positions, found[3].positions)


def test_an_iterable_gives_an_iterator():
    made = embedded("CCCO")
    with pytest.warns(pliant.PliantWarning, match="^molecule 3: the same molecule as molecule 1:"):
        found = list(pliant.conformers(iter([made, "C1CC", pliant.from_rdkit(made), 3]), 2, **FAST))
    assert found[0].GetNumConformers() == len(found[2]) == 2
    assert found[1].reason == "record 1: SMILES 'C1CC': expected a molecule, RDKit cannot read it"
    assert (found[3].number, found[3].reason) == (
        4,
        "molecule 4: expected an rdkit.Chem.Mol, a SMILES or a Structure, found 3",
    )


def test_stereo_that_is_left_open_is_warned_of(tmp_path):
    said = "1 stereo centre is not given: one isomer was made"
    with pytest.warns(pliant.PliantWarning, match=f"^CC\\(F\\)CO: {said}$"):
        pliant.conformers("CC(F)CO", 2, **FAST)
    with pytest.warns(pliant.PliantWarning, match=f"^molecule 2 \\(CC\\(F\\)CO\\): {said}$"):
        list(pliant.conformers(["CCO", "CC(F)CO"], 2, **FAST))
    (tmp_path / "some.smi").write_text("CC(F)CO open\n")
    with pytest.warns(pliant.PliantWarning, match=f"^some.smi record 1 \\(open\\): {said}$"):
        (found,) = pliant.conformers(tmp_path / "some.smi", 2, **FAST)
    assert found.notes[0] == said


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"max": 0}, "max = 0: must be from 1"),
        ({"rms": -1.0}, "rms = -1: must be 0 or more and finite"),
        ({"window": -1.0}, "window = -1: must be positive and finite"),
        ({"energy": "none", "window": 3.0}, "window: needs an energy, not energy none"),
        (
            {"energy": "own", "minimise": True},
            "minimise: needs MMFF94s, UFF or a force field, not energy own",
        ),
    ],
)
def test_wrong_options_are_named(options, message):
    with pytest.raises(pliant.OptionError) as caught:
        pliant.conformers("CCO", **options)
    assert str(caught.value) == message
