# SPDX-License-Identifier: MIT
"""Functions take molecules of any kind, and get the same of each."""

import numpy as np
import pytest
from real_files import DIPEPTIDE, MOLECULES

import pliant

pytestmark = pytest.mark.filterwarnings(
    "ignore:frames reach an amplitude", "ignore:no bond can rotate", "ignore:select. .* bonds"
)


def universe(structure):
    pytest.importorskip("MDAnalysis")
    return pliant.to_mdanalysis(structure)


def atoms(structure):
    return universe(structure).atoms


def molecule(structure):
    pytest.importorskip("rdkit")
    return pliant.to_rdkit(structure)


def modeller(structure):
    pytest.importorskip("openmm")
    return pliant.to_openmm(structure)


def mdtraj_trajectory(structure):
    pytest.importorskip("mdtraj")
    return pliant.to_mdtraj(structure)


def atom_group(structure):
    pytest.importorskip("prody")
    return pliant.to_prody(structure)


#: how the peptide is given
GIVEN = {
    "path": lambda structure: DIPEPTIDE,
    "text": lambda structure: str(DIPEPTIDE),
    "structure": lambda structure: structure,
    "trajectory": pliant.Trajectory,
    "ensemble": lambda structure: pliant.sample(structure, frames=2, seed=1),
    "universe": universe,
    "atoms": atoms,
    "rdkit": molecule,
    "openmm": modeller,
    "mdtraj": mdtraj_trajectory,
    "prody": atom_group,
}

#: what is asked of it, as numbers
ASKED = {
    "sample": lambda given: pliant.sample(given, frames=2, seed=3).positions.shape,
    "run": lambda given: pliant.run(given, steps=3, seed=3)[-1].shape,
    "rigidity": lambda given: pliant.rigidity(given).degrees_of_freedom,
    "contacts": lambda given: pliant.contacts(given)["kind"].tolist(),
    "build_model": lambda given: pliant.build_model(given).framework.bar_count,
    "prepare": lambda given: pliant.prepare(given).structure.bonds.tolist(),
}


@pytest.mark.parametrize("asked", ASKED)
@pytest.mark.parametrize("kind", GIVEN)
def test_every_kind_is_taken(kind, asked):
    structure = pliant.read(DIPEPTIDE)
    given = GIVEN[kind](structure)
    assert ASKED[asked](given) == ASKED[asked](structure)


@pytest.mark.parametrize("kind", [kind for kind in GIVEN if kind != "ensemble"])
def test_a_path_is_found_from_any_kind(kind):
    structure = pliant.read(MOLECULES / "peptide_20.pdb")
    given = MOLECULES / "peptide_20.pdb" if kind in ("path", "text") else GIVEN[kind](structure)
    found = pliant.path(given, pliant.sample(structure, frames=1, seed=1)[:])
    assert len(found) == len(found.frames) == len(found.positions)


@pytest.mark.parametrize("kind", GIVEN)
def test_a_view_shows_any_kind(kind):
    from pliant.play.view import given_of

    structure = pliant.read(DIPEPTIDE)
    shown = given_of(GIVEN[kind](structure))
    assert shown.data
    if kind != "text" and kind != "path":
        assert shown.start.shape == structure.positions.shape


def test_charges_come_from_rdkit_and_go_there():
    Chem = pytest.importorskip("rdkit.Chem")
    from rdkit.Chem import AllChem

    made = Chem.AddHs(Chem.MolFromSmiles("C[NH2+]CC(=O)[O-]"))
    AllChem.EmbedMolecule(made, randomSeed=1)
    structure = pliant.from_rdkit(made)
    assert structure.charges.sum() == 0
    assert sorted(set(structure.charges.tolist())) == [-1, 0, 1]
    back = pliant.to_rdkit(structure)
    assert Chem.MolToSmiles(back) == Chem.MolToSmiles(made)
    bare = pliant.Structure(
        structure.positions,
        elements=structure.elements,
        bonds=structure.bonds,
        bond_orders=structure.bond_orders,
    )
    assert len(bare.charges) == 0
    assert Chem.MolToSmiles(pliant.to_rdkit(bare)) == Chem.MolToSmiles(made)  # by valence


def test_charges_that_are_none_are_refused():
    positions = np.zeros((2, 3))
    with pytest.raises(pliant.InputError, match=r"charges: 1 for 2 atoms"):
        pliant.Structure(positions, charges=[1])
    with pytest.raises(pliant.InputError, match=r"charges\[1\]: expected -127 to 127, found 500"):
        pliant.Structure(positions, charges=[1, 500])


def test_contacts_of_what_has_no_hydrogens_say_so():
    protein = pliant.read(DIPEPTIDE).select("not element H")
    with pytest.warns(pliant.PliantWarning, match=r"pliant\.contacts\(pliant\.prepare\(molecule\)"):
        pliant.contacts(protein)


def test_contacts_are_read_as_the_command_writes_them(tmp_path):
    import subprocess

    from pliant.base.console import command_path

    path = MOLECULES / "peptide_20.pdb"
    file = tmp_path / "contacts.csv"
    with file.open("w") as stream:
        subprocess.run([command_path(), "contacts", path, "--csv"], stdout=stream, check=True)
    model = pliant.build_model(path)
    found = pliant.read_contacts(file, model)
    assert found.dtype == model.contacts.dtype
    assert found[["kind", "a", "b"]].tolist() == model.contacts[["kind", "a", "b"]].tolist()
