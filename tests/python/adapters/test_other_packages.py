# SPDX-License-Identifier: MIT
"""Frames go to other packages and come back, through one object."""

import numpy as np
import pytest
from real_files import MOLECULES

import pliant

pytestmark = pytest.mark.filterwarnings(
    "ignore:frames reach an amplitude", "ignore:no bond can rotate", "ignore:select. .* bonds"
)


@pytest.fixture(scope="module")
def ensemble():
    return pliant.sample(MOLECULES / "peptide_20.pdb", frames=3, seed=1)


#: package, what makes its object, how many frames that has, and how near they are kept, Angstrom
PACKAGES = {
    "MDAnalysis": ("to_mdanalysis", lambda made: len(made.trajectory), 2e-5),
    "rdkit": ("to_rdkit", lambda made: made.GetNumConformers(), 0.0),
    "mdtraj": ("to_mdtraj", len, 2e-5),
    "prody": ("to_prody", lambda made: made.numCoordsets(), 0.0),
    "openmm": ("to_openmm", lambda made: 1, 1e-12),
}


@pytest.mark.parametrize("package", PACKAGES)
def test_frames_go_there_and_back(package, ensemble):
    pytest.importorskip(package)
    name, count, near = PACKAGES[package]
    made = getattr(ensemble, name)()
    frames = 1 if package == "openmm" else len(ensemble)
    assert count(made) == frames
    back = pliant.Trajectory(made)
    assert len(back) == frames
    assert np.abs(back.positions - ensemble.positions[:frames]).max() <= near
    ours, theirs = ensemble.structure, back.structure
    for column in ("names", "elements", "residue_names", "residue_ids", "chains"):
        assert np.array_equal(getattr(theirs, column), getattr(ours, column)), column
    assert np.array_equal(theirs.bonds, ours.bonds)


@pytest.mark.parametrize("package", PACKAGES)
def test_what_came_from_there_is_sampled(package, ensemble):
    pytest.importorskip(package)
    made = getattr(pliant, PACKAGES[package][0])(ensemble.structure)
    assert len(pliant.sample(made, frames=2, seed=1)) == 2


def test_rdkit_reads_the_chemistry():
    Chem = pytest.importorskip("rdkit.Chem")
    from rdkit.Chem import AllChem

    for smiles in ("C[C@H](N)C(=O)O", "c1ccccc1C#N", "C[N+](C)(C)C", "OC[C@@H]1OC[C@H](O)C1"):
        made = Chem.AddHs(Chem.MolFromSmiles(smiles))
        AllChem.EmbedMolecule(made, randomSeed=2)
        conformers = pliant.sample(made, frames=2, seed=1).to_rdkit()
        assert conformers.GetNumConformers() == 2
        assert Chem.MolToSmiles(Chem.RemoveHs(conformers)) == Chem.CanonSmiles(smiles)


def test_residues_are_known_to_rdkit(ensemble):
    pytest.importorskip("rdkit")
    atom = ensemble.to_rdkit().GetAtomWithIdx(0)
    assert atom.GetPDBResidueInfo().GetResidueName().strip() == ensemble.structure.residue_names[0]


def test_openmm_has_the_frame_that_is_asked_for(ensemble):
    pytest.importorskip("openmm")
    from openmm import unit

    positions = np.array(ensemble.to_openmm(-1).positions.value_in_unit(unit.angstrom))
    assert np.abs(positions - ensemble[-1]).max() < 1e-12
    with pytest.raises(IndexError, match="frame 3: there are 3"):
        ensemble.to_openmm(3)


def test_a_universe_stays_at_its_frame(ensemble):
    pytest.importorskip("MDAnalysis")
    universe = ensemble.to_mdanalysis()
    universe.trajectory[1]
    assert len(list(pliant.Trajectory(universe))) == 3
    assert universe.trajectory.frame == 1
    part = pliant.Trajectory(universe.select_atoms("name CA"))
    assert part[2].shape == (20, 3)


def test_a_selection_of_prody_has_its_bonds(ensemble):
    pytest.importorskip("prody")
    part = ensemble.to_prody().select("resnum 2 3")
    structure = pliant.from_prody(part)
    assert len(structure) == part.numAtoms()
    assert len(structure.bonds) >= len(structure) - 1


@pytest.mark.parametrize("package", [name for name in PACKAGES if name != "openmm"])
def test_functions_convert_as_methods_do(package, ensemble):
    pytest.importorskip(package)
    name, count, _ = PACKAGES[package]
    assert count(getattr(pliant, name)(ensemble[1:])) == 2
