# SPDX-License-Identifier: MIT
"""from_mdanalysis and to_mdanalysis: names, residues, bonds and positions, there and back."""

import subprocess
import sys
import warnings

import numpy as np
import pytest

import pliant

mda = pytest.importorskip("MDAnalysis")
pytest.importorskip("MDAnalysisTests")


COLUMNS = (
    "elements",
    "names",
    "residue_names",
    "residue_ids",
    "insertion_codes",
    "chains",
    "serials",
    "residue_of",
    "bonds",
    "bond_orders",
)


def pairs(structure):
    return {tuple(bond) for bond in structure.bonds.tolist()}


def test_import_needs_none_of_them():
    script = (
        "import sys, pliant\n"
        "names = ('MDAnalysis', 'openmm', 'rdkit', 'h5py')\n"
        "print(*(name for name in names if name in sys.modules))"
    )
    done = subprocess.run(
        [sys.executable, "-c", script], capture_output=True, text=True, check=True
    )
    assert done.stdout.strip() == ""


@pytest.fixture
def adk():
    from MDAnalysisTests.datafiles import DCD, PSF

    return mda.Universe(PSF, DCD)


def test_names_residues_bonds_and_the_current_frame(adk):
    adk.trajectory[7]
    with pytest.warns(pliant.PliantWarning, match="guessed from names") as caught:
        structure = pliant.from_mdanalysis(adk)
    assert [warning.filename for warning in caught] == [__file__]
    assert len(structure) == 3341
    assert np.array_equal(structure.positions, adk.atoms.positions.astype(float))
    assert structure.names.tolist() == adk.atoms.names.tolist()
    assert structure.residue_names.tolist() == adk.atoms.resnames.tolist()
    assert structure.residue_ids.tolist() == adk.atoms.resids.tolist()
    assert set(structure.chains) == {"4AKE"}
    assert pairs(structure) == {tuple(sorted(b)) for b in adk.bonds.indices.tolist()}
    np.testing.assert_allclose(structure.masses, adk.atoms.masses, atol=0.02)


@pytest.mark.filterwarnings("ignore::pliant.PliantWarning")
def test_of_a_group_only_the_bonds_within_come_over(adk):
    group = adk.select_atoms("resid 20-22 and not name CA")
    structure = pliant.from_mdanalysis(group)
    places = {index: place for place, index in enumerate(group.indices.tolist())}
    expected = {
        (places[a], places[b]) for a, b in adk.bonds.indices.tolist() if a in places and b in places
    }
    assert pairs(structure) == {tuple(sorted(pair)) for pair in expected}
    assert structure.names.tolist() == group.names.tolist()


@pytest.mark.filterwarnings("ignore::pliant.PliantWarning")
def test_bonds_are_perceived_where_there_are_none(adk):
    from MDAnalysisTests.datafiles import PDB_small

    structure = pliant.from_mdanalysis(mda.Universe(PDB_small))
    assert len(structure.bonds) == 3365
    assert set(structure.bond_origins) == {"residue", "link"}
    assert pairs(structure) == pairs(pliant.from_mdanalysis(adk))
    bare = pliant.from_mdanalysis(mda.Universe(PDB_small), perceive_bonds=False)
    assert len(bare.bonds) == 0


def test_orders_and_elements_of_a_mol2_file():
    from MDAnalysisTests.datafiles import mol2_molecule

    universe = mda.Universe(mol2_molecule)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        structure = pliant.from_mdanalysis(universe)
    assert structure.symbols.tolist() == universe.atoms.elements.tolist()
    orders = {tuple(sorted(b.indices)): b.order for b in universe.bonds}
    expected = [
        {"1": 1, "2": 2, "3": 3, "ar": 4}.get(orders[tuple(b)], 0) for b in structure.bonds.tolist()
    ]
    assert structure.bond_orders.tolist() == expected
    assert len(set(expected)) > 1


@pytest.mark.filterwarnings("ignore::pliant.PliantWarning")
def test_there_and_back_again(adk):
    from MDAnalysisTests.datafiles import PDB_multiframe

    for universe in (adk, mda.Universe(PDB_multiframe)):
        one = pliant.from_mdanalysis(universe)
        two = pliant.from_mdanalysis(pliant.to_mdanalysis(one))
        for column in COLUMNS:
            assert np.array_equal(getattr(one, column), getattr(two, column)), column
        np.testing.assert_allclose(two.positions, one.positions, atol=1e-5)


def test_a_trajectory_in_memory():
    water = pliant.read_text("3\nw\nO 0 0 0\nH 0.96 0 0\nH -0.24 0.93 0\n", "w.xyz")
    frames = []
    pliant.run(water, steps=4, observers=[lambda f: frames.append(f.positions.copy())])
    universe = pliant.to_mdanalysis(water, frames, timestep=0.01)
    assert universe.trajectory.n_frames == 5
    assert universe.trajectory[2].time == pytest.approx(0.02)
    for ts, expected in zip(universe.trajectory, frames, strict=True):
        np.testing.assert_allclose(ts.positions, expected, atol=1e-6)
    assert universe.atoms.fragments[0].n_atoms == 3
    assert universe.atoms.elements.tolist() == ["O", "H", "H"]


def test_a_framework_as_a_universe():
    framework = pliant.Framework([[0, 1], [1, 2]], [1, 2], masses=[4, 5, 6], pinned=[2])
    with pytest.raises(TypeError, match="a framework has no positions"):
        pliant.to_mdanalysis(framework)
    with pytest.raises(pliant.InputError) as caught:
        pliant.to_mdanalysis(framework, np.zeros((2, 3)))
    assert str(caught.value) == ("positions: expected shape (3, 3) or (F, 3, 3), found (2, 3)")
    universe = pliant.to_mdanalysis(framework, np.arange(9).reshape(3, 3))
    assert universe.bonds.indices.tolist() == [[0, 1], [1, 2]]
    assert universe.atoms.masses.tolist() == [4, 5, 0]
    assert universe.atoms.names.tolist() == ["joint 0", "joint 1", "joint 2"]
