# SPDX-License-Identifier: MIT
"""from_openmm and constraints_from_openmm: packaged files, units, constraints as bars."""

from pathlib import Path

import numpy as np
import pytest

import pliant

app = pytest.importorskip("openmm.app")


LARGE = pytest.param("POPC.pdb", marks=pytest.mark.long)


def pairs(structure):
    return {tuple(bond) for bond in structure.bonds.tolist()}


def packaged(name):
    return app.PDBFile(str(Path(app.__file__).parent / "data" / name))


@pytest.mark.filterwarnings("ignore::pliant.PliantWarning")
@pytest.mark.parametrize("name", ["tip3p.pdb", "tip5p.pdb", "test.pdb", LARGE])
def test_packaged_files_come_over_as_our_reader_reads_them(name):
    pdb = packaged(name)
    theirs = pliant.from_openmm(pdb.topology, pdb.positions)
    ours = pliant.read(Path(app.__file__).parent / "data" / name)
    np.testing.assert_allclose(theirs.positions, ours.positions, rtol=0, atol=1e-9)
    assert pairs(theirs) == pairs(ours)
    assert theirs.residue_ids.tolist() == ours.residue_ids.tolist()
    assert set(theirs.bond_origins) == {"file"}


def test_columns_are_those_of_the_topology():
    pdb = packaged("test.pdb")
    structure = pliant.from_openmm(pdb.topology, pdb.positions)
    atoms = list(pdb.topology.atoms())
    assert structure.names.tolist() == [atom.name for atom in atoms]
    assert structure.elements.tolist() == [atom.element.atomic_number for atom in atoms]
    assert len(structure.bonds) == pdb.topology.getNumBonds()


def test_bare_numbers_are_nanometres():
    pdb = packaged("tip3p.pdb")
    from openmm import unit

    quantity = pdb.getPositions(asNumpy=True)
    again = quantity.in_units_of(unit.bohr), list(pdb.positions)
    for positions in (quantity, quantity.value_in_unit(unit.nanometer), pdb.positions, *again):
        structure = pliant.from_openmm(pdb.topology, positions)
        expected = quantity.value_in_unit(unit.angstrom)
        np.testing.assert_allclose(structure.positions, expected, rtol=1e-12)


@pytest.mark.filterwarnings("ignore::pliant.PliantWarning")
def test_constraints_become_bars():
    from openmm import unit

    pdb = packaged("test.pdb")
    field = app.ForceField("amber14-all.xml", "amber14/tip3p.xml")
    modeller = app.Modeller(pdb.topology, pdb.positions)
    modeller.delete([r for r in modeller.topology.residues() if r.name in {"Cl", "Na"}])
    system = field.createSystem(modeller.topology, constraints=app.HBonds)
    structure = pliant.from_openmm(modeller.topology, modeller.positions)
    framework = pliant.constraints_from_openmm(system, structure)
    assert framework.bar_count == system.getNumConstraints() > 1000
    for k in range(0, framework.bar_count, 997):
        first, second, length = system.getConstraintParameters(k)
        assert framework.bars[k].tolist() == [first, second]
        assert framework.rest_lengths[k] == pytest.approx(length.value_in_unit(unit.angstrom))
    assert framework.rest_lengths.max() < 2
    assert framework.inverse_masses[0] == pytest.approx(
        1 / system.getParticleMass(0).value_in_unit(unit.dalton)
    )
    assert framework.label(0) == structure.label(0)
    assert pliant.measure_bars(framework, structure.positions).max_relative < 0.2


def test_particles_without_mass_are_pinned():
    import openmm

    system = openmm.System()
    for mass in (12.0, 0.0, 1.0):
        system.addParticle(mass)
    system.addConstraint(0, 1, 0.25)
    framework = pliant.constraints_from_openmm(system)
    assert framework.pinned.tolist() == [1]
    assert framework.bars.tolist() == [[0, 1]]
    assert framework.rest_lengths.tolist() == [2.5]
    assert framework.joint_count == 3


def test_odd_residue_ids_are_warned_of():
    topology = app.Topology()
    residue = topology.addResidue("LIG", topology.addChain("Z"), id="1F")
    topology.addAtom("C1", app.Element.getBySymbol("C"), residue)
    topology.addAtom("EP", None, residue)
    with pytest.warns(pliant.PliantWarning, match=r"^residue id '1F' is no number") as caught:
        structure = pliant.from_openmm(topology, [[0, 0, 0], [0.1, 0, 0]], perceive_bonds=False)
    assert [warning.filename for warning in caught] == [__file__]
    assert structure.residue_ids.tolist() == [1, 1]
    assert structure.elements.tolist() == [6, 0]
    assert structure.label(0) == "C1(1)"
