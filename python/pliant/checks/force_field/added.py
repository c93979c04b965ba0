# SPDX-License-Identifier: MIT
"""Molecules with AMBER topologies of their own, added to an OpenMM System, in the worker's process.

A template of ForceField has their elements, charges and sizes; bonds, angles and torsions are added
one by one, as the topology lists them.
"""

from __future__ import annotations

import io
import tempfile
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import openmm
from openmm import app

#: nm, kJ/mol: what OpenMM's implicit files and amber14 have
SCALES = 'coulomb14scale="0.8333333333333334" lj14scale="0.5"'


@dataclass
class Added:
    """A residue that a topology describes."""

    name: str  #: of its template
    where: np.ndarray  #: (L,) particle of the System that each atom of the topology is
    topology: app.Topology
    system: openmm.System  #: of it alone, without water

    def register(self, field: app.ForceField) -> None:
        """Gives a ForceField the template."""
        field.loadFile(io.StringIO(self._xml()))

    def _xml(self) -> str:
        nonbonded = force_of(self.system, openmm.NonbondedForce)
        types, atoms, sizes = [], [], []
        for k, atom in enumerate(self.topology.atoms()):
            charge, sigma, epsilon = (
                one._value for one in nonbonded.getParticleParameters(k)
            )
            kind, mass = f"{self.name}-{k}", atom.element.mass._value
            types.append(
                f'<Type name="{kind}" class="{kind}" element="{atom.element.symbol}" mass="{mass}"/>'
            )
            atoms.append(f'<Atom name="{kind}" type="{kind}" charge="{charge!r}"/>')
            sizes.append(f'<Atom type="{kind}" sigma="{sigma!r}" epsilon="{epsilon!r}"/>')
        bonds = [
            f'<Bond from="{a.index}" to="{b.index}"/>' for a, b in self.topology.bonds()
        ]
        return (
            f"<ForceField><AtomTypes>{''.join(types)}</AtomTypes><Residues>"
            f'<Residue name="{self.name}">{"".join(atoms)}{"".join(bonds)}</Residue></Residues>'
            f'<NonbondedForce {SCALES}><UseAttributeFromResidue name="charge"/>{"".join(sizes)}'
            "</NonbondedForce></ForceField>"
        )

    def add_terms(self, system: openmm.System, *, constrain: bool) -> None:
        """Adds bonds, angles and torsions; `constrain`: bonds of hydrogens are constraints."""
        where = self.where.tolist()
        own = force_of(self.system, openmm.HarmonicBondForce)
        bonds = force_of(system, openmm.HarmonicBondForce)
        for k in range(own.getNumBonds()):
            a, b, length, strength = own.getBondParameters(k)
            if constrain and any(self.is_hydrogen(end) for end in (a, b)):
                system.addConstraint(where[a], where[b], length)
            else:
                bonds.addBond(where[a], where[b], length, strength)
        own = force_of(self.system, openmm.HarmonicAngleForce)
        angles = force_of(system, openmm.HarmonicAngleForce)
        for k in range(own.getNumAngles()):
            a, b, c, *values = own.getAngleParameters(k)
            angles.addAngle(where[a], where[b], where[c], *values)
        own = force_of(self.system, openmm.PeriodicTorsionForce)
        torsions = force_of(system, openmm.PeriodicTorsionForce)
        for k in range(own.getNumTorsions()):
            a, b, c, d, *values = own.getTorsionParameters(k)
            torsions.addTorsion(where[a], where[b], where[c], where[d], *values)

    def is_hydrogen(self, atom: int) -> bool:
        """Of the topology's atoms."""
        return bool(self._elements[atom] == 1)

    def __post_init__(self) -> None:
        self._elements = [atom.element.atomic_number for atom in self.topology.atoms()]


def added_of(prmtop: bytes, where: np.ndarray, name: str) -> Added:
    """Of the text of an AMBER topology."""
    with tempfile.TemporaryDirectory(prefix="pliant-prmtop-") as folder:
        file = Path(folder, "ligand.prmtop")
        file.write_bytes(prmtop)
        read = app.AmberPrmtopFile(str(file))
    system = read.createSystem(nonbondedMethod=app.NoCutoff, removeCMMotion=False)
    return Added(name, where, read.topology, system)


def force_of(system: openmm.System, kind: type) -> Any:
    """The first force of a kind; one that is added where there is none."""
    found = next((force for force in system.getForces() if isinstance(force, kind)), None)
    if found is None:
        found = system.getForce(system.addForce(kind()))
    return found
