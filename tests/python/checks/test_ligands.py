# SPDX-License-Identifier: MIT
"""Ligands under the force field: their chemistry, parameters, what is refused."""

import numpy as np
import pytest
from pliant.checks.ligands import parameters
from pliant.checks.ligands.chemistry import chemistry_of
from pliant.checks.ligands.guessed_orders import guess_orders

import pliant

Chem = pytest.importorskip("rdkit.Chem")
pytest.importorskip("scipy")
from rdkit.Chem import AllChem  # noqa: E402

DRUGS = {
    "progesterone": "CC(=O)C1CCC2C3CCC4=CC(=O)CCC4(C)C3CCC12C",
    "caffeine": "Cn1cnc2c1c(=O)n(C)c(=O)n2C",
    "nitrobenzene": "O=[N+]([O-])c1ccccc1",
    "benzonitrile": "N#Cc1ccccc1",
    "adenosine": "Nc1ncnc2c1ncn2C1OC(CO)C(O)C1O",
    "sulfadiazine": "Nc1ccc(S(=O)(=O)Nc2ncccn2)cc1",
    "aspirin": "CC(=O)Oc1ccccc1C(=O)[O-]",
    "dopamine": "[NH3+]CCc1ccc(O)c(O)c1",
    "acetylcholine": "CC(=O)OCC[N+](C)(C)C",
}


def embedded(smiles):
    made = Chem.AddHs(Chem.MolFromSmiles(smiles))
    assert AllChem.EmbedMolecule(made, randomSeed=1) == 0
    AllChem.MMFFOptimizeMolecule(made, "MMFF94s", maxIters=2000)
    return made


def bare(molecule):
    """Only elements, single bonds and places of atoms without hydrogens."""
    made = Chem.RWMol(Chem.RemoveAllHs(molecule))
    for bond in made.GetBonds():
        bond.SetBondType(Chem.BondType.SINGLE)
        bond.SetIsAromatic(False)
    for atom in made.GetAtoms():
        atom.SetFormalCharge(0)
        atom.SetIsAromatic(False)
        atom.SetNoImplicit(True)
        atom.SetNumExplicitHs(0)
    return made.GetMol()


@pytest.mark.parametrize("name", DRUGS)
def test_bond_orders_are_guessed_from_lengths(name):
    molecule = bare(embedded(DRUGS[name]))
    guess_orders(molecule)
    found = Chem.MolToSmiles(Chem.RemoveHs(molecule), isomericSmiles=False)
    assert found == Chem.CanonSmiles(DRUGS[name])


def structure_of(smiles, name="LIG"):
    """Without hydrogens, as in a crystal structure."""
    molecule = Chem.RemoveAllHs(embedded(smiles))
    bonds = [(b.GetBeginAtomIdx(), b.GetEndAtomIdx()) for b in molecule.GetBonds()]
    return pliant.Structure(
        molecule.GetConformer().GetPositions(),
        elements=[atom.GetAtomicNum() for atom in molecule.GetAtoms()],
        names=[f"{atom.GetSymbol()}{k}" for k, atom in enumerate(molecule.GetAtoms())],
        residue_names=[name] * molecule.GetNumAtoms(),
        residue_ids=[1] * molecule.GetNumAtoms(),
        bonds=bonds,
    )


def test_hydrogens_are_placed_in_each_frame_alike():
    part = structure_of(DRUGS["progesterone"])
    found = chemistry_of(part, "LIG1", {})
    assert (found.given, found.molecule.GetNumAtoms(), found.charge) == (23, 53, 0)
    moved = part.positions[:, [1, 2, 0]] + 5  # turned: hydrogens turn with the rest
    whole, turned = found.complete(part.positions), found.complete(moved)
    assert whole[:23].tobytes() == part.positions.tobytes()
    apart = np.linalg.norm(whole[:, None, [1, 2, 0]] + 5 - turned, axis=2).min(axis=1)
    assert np.median(apart) < 1e-6  # RDKit turns methyls by the axes
    assert found.complete(moved).tobytes() == turned.tobytes()


def test_a_smiles_says_more_than_lengths():
    part = structure_of("CC(=O)O")
    assert chemistry_of(part, "LIG1", {}).charge == -1
    assert chemistry_of(part, "LIG1", {"LIG": "CC(=O)O"}).charge == 0
    with pytest.raises(pliant.InputError, match="LIG1: is not 'CCO': expected C2 O1"):
        chemistry_of(part, "LIG1", {"LIG": "CCO"})


@pytest.mark.parametrize(
    ("element", "why"),
    [(26, "GAFF2 has no parameters for Fe"), (5, "GAFF2 has no parameters for B")],
)
def test_metals_and_boron_are_refused(element, why):
    part = structure_of("CC(=O)O")
    elements = part.elements.copy()
    elements[0] = element
    other = pliant.Structure(part.positions, elements=elements, bonds=part.bonds)
    with pytest.raises(pliant.InputError, match=f"LIG1: {why}"):
        chemistry_of(other, "LIG1", {})


def test_odd_electrons_are_refused():
    with pytest.raises(pliant.InputError, match=r"LIG1: expected paired electrons, found 32"):
        chemistry_of(structure_of("CC(=O)O"), "LIG1", {"LIG": "C[C](O)[O]"})


# Parameters


def test_the_key_does_not_depend_on_the_sequence_of_atoms():
    molecule = embedded(DRUGS["caffeine"])
    order = np.random.default_rng(1).permutation(molecule.GetNumAtoms()).tolist()
    shuffled = Chem.RenumberAtoms(molecule, order)
    (text, one), (same, other) = parameters.canonical(molecule), parameters.canonical(shuffled)
    assert text == same
    elements = [[m.GetAtomWithIdx(int(k)).GetAtomicNum() for k in o] for m, o in
                ((molecule, one), (shuffled, other))]  # fmt: skip
    assert elements[0] == elements[1]
    key = parameters.key(text, "am1-bcc", "2.2")
    assert len(key) == 32 == len({*key} | {*range(32 - len({*key}))})
    others = [(text, "gasteiger", "2.2"), (text, "am1-bcc", "2.3"), (text + "C", "am1-bcc", "2.2")]
    assert key not in [parameters.key(*one) for one in others]


def test_parameters_are_kept_where_xdg_says(monkeypatch, tmp_path):
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    assert parameters.folder() == tmp_path / "pliant" / "ligands"
    monkeypatch.setenv("XDG_CACHE_HOME", "relative")  # which the specification has ignored
    assert parameters.folder().parts[-3:] == (".cache", "pliant", "ligands")


def made(say=lambda _: None, smiles="C"):
    return parameters.parameters_of(embedded(smiles), "am1-bcc", "A:LIG1", say)


def test_parameters_are_made_once(tools):
    folder, said = tools(), []
    first = made(said.append)
    assert not first.was_kept
    assert said == ["A:LIG1: 1 atoms without hydrogens get GAFF2 and am1-bcc charges, once"]
    calls = (folder / "calls").read_text()
    again = made()
    assert again.was_kept and again.prmtop == first.prmtop
    assert (folder / "calls").read_text() == calls
    (kept,) = parameters.folder().iterdir()
    kept.write_text("torn")
    assert not made().was_kept


FAULTS = [
    ({"antechamber": None, "sqm": None}, "AmberTools' antechamber, sqm not found: pip install"),
    (
        {"antechamber": "echo 'Fatal Error!'; echo 'Weird atomic valence'; exit 1"},
        "antechamber: exit code 1: Fatal Error! Weird atomic valence",
    ),
    ({"antechamber": "echo nothing"}, "antechamber: nothing"),
    ({"parmchk2": "exit 3"}, "parmchk2: exit code 3: no output"),
    ({"tleap": "echo hello"}, "tleap: expected the version of GAFF2, found 'hello'"),
    (
        {"antechamber": "echo 'Error: the number of electrons is odd (11)'; exit 1"},
        "antechamber: exit code 1: Error: the number of electrons is odd (11)",
    ),
]


@pytest.mark.parametrize(("scripts", "why"), FAULTS)
def test_what_is_wrong_with_ambertools_is_one_line(tools, scripts, why):
    tools(**scripts)
    with pytest.raises(pliant.InputError) as found:
        made()
    assert str(found.value).startswith(f"A:LIG1: {why}")
    assert "\n" not in str(found.value)


def test_a_topology_of_other_atoms_is_refused(tools):
    tools()
    with pytest.raises(pliant.InputError, match="A:LIG1: tleap: expected 8 atoms, found 5"):
        made(smiles="CC")
