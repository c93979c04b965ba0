# SPDX-License-Identifier: MIT
"""Molecules with AMBER topologies of their own, added to an OpenMM System, in the worker's process.

A template of ForceField has their elements, charges and sizes; bonds, angles and torsions are added
one by one, as the topology lists them.
"""

from __future__ import annotations

import io
import tempfile
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import openmm
from openmm import app

from pliant.base.new_file import write_bytes

#: forces by what their terms are called, and how many atoms a term has
FORCES = {
    "Bond": (openmm.HarmonicBondForce, 2),
    "Angle": (openmm.HarmonicAngleForce, 3),
    "Torsion": (openmm.PeriodicTorsionForce, 4),
}
#: of pairs three bonds apart, as in amber14
SCALES = 'coulomb14scale="0.8333333333333334" lj14scale="0.5"'


#: Type in amber14 and charge of the backbone, those of residues without a charge (J. A. Maier et
#: al., J. Chem. Theory Comput. 11 (2015) 3696). CA and its hydrogen have a charge of each residue.
BACKBONE: dict[str, tuple[str, float | None]] = {
    "N": ("protein-N", -0.4157),
    "H": ("protein-H", 0.2719),
    "CA": ("protein-CX", None),
    "C": ("protein-C", 0.5973),
    "O": ("protein-O", -0.5679),
}


@dataclass
class Added:
    """A molecule, or a residue between caps, that a topology describes.

    The backbone of a residue has types of amber14, and what it shares with other residues is that
    of amber14; the charge that this leaves is shared by its other atoms.
    """

    name: str  #: of its template
    where: np.ndarray  #: (L,) particle of the System that each atom of the topology is, or -1
    own: np.ndarray  #: (L,) whether it is no cap
    names: list[str]  #: (L,) in the System
    topology: app.Topology
    system: openmm.System  #: of it alone, without water

    def __post_init__(self) -> None:
        self._elements = [atom.element.atomic_number for atom in self.topology.atoms()]
        self._backbone = [self._known(k) for k in range(len(self.own))]

    def _known(self, atom: int) -> tuple[str, float | None] | None:
        """Of an atom of a residue's backbone. Hydrogens that were placed are all called H."""
        if self.is_molecule or not self.own[atom]:
            return None
        near = [
            b.index if a.index == atom else a.index
            for a, b in self.topology.bonds()
            if atom in (a.index, b.index)
        ]
        name = self.names[atom]
        return None if name == "H" and self.names[near[0]] != "N" else BACKBONE.get(name)

    @property
    def is_molecule(self) -> bool:
        """No caps."""
        return bool(self.own.all())

    def register(self, field: app.ForceField) -> None:
        """Gives a ForceField the template."""
        field.loadFile(io.StringIO(self._xml()))

    def _charges(self) -> list[float]:
        """Of all atoms, of which those that are its own have a whole charge together."""
        nonbonded = force_of(self.system, openmm.NonbondedForce)
        charges = np.array(
            [nonbonded.getParticleParameters(k)[0]._value for k in range(len(self.own))]
        )
        fixed = np.zeros(len(charges), bool)
        whole = round(float(charges.sum()))
        for k, known in enumerate(self._backbone):
            if known is not None and known[1] is not None:
                charges[k], fixed[k] = known[1], True
        free = self.own & ~fixed
        charges[free] += (whole - charges[self.own].sum()) / free.sum()
        found: list[float] = charges.tolist()
        return found

    def _xml(self) -> str:
        nonbonded = force_of(self.system, openmm.NonbondedForce)
        charges = self._charges()
        types, atoms, sizes = [], [], []
        for k, atom in enumerate(self.topology.atoms()):
            if not self.own[k]:
                continue
            _, sigma, epsilon = (one._value for one in nonbonded.getParticleParameters(k))
            kind, mass = self._type(k), atom.element.mass._value
            atoms.append(f'<Atom name="{k}" type="{kind}" charge="{charges[k]!r}"/>')
            if self._backbone[k] is None:
                types.append(
                    f'<Type name="{kind}" class="{kind}" element="{atom.element.symbol}" '
                    f'mass="{mass}"/>'
                )
                sizes.append(f'<Atom type="{kind}" sigma="{sigma!r}" epsilon="{epsilon!r}"/>')
        bonds = [
            f'<Bond atomName1="{a.index}" atomName2="{b.index}"/>'
            for a, b in self.topology.bonds()
            if self.own[a.index] and self.own[b.index]
        ]
        return (
            f"<ForceField><AtomTypes>{''.join(types)}</AtomTypes><Residues>"
            f'<Residue name="{self.name}">{"".join(atoms)}{"".join(bonds)}</Residue></Residues>'
            f'<NonbondedForce {SCALES}><UseAttributeFromResidue name="charge"/>{"".join(sizes)}'
            "</NonbondedForce></ForceField>"
        )

    def _type(self, atom: int) -> str:
        known = self._backbone[atom]
        return f"{self.name}-{atom}" if known is None else known[0]

    def _is_added(self, atoms: list[int]) -> bool:
        """Whether a term is the topology's: all its atoms are there, and one is not amber14's."""
        is_there = all(self.where[k] >= 0 for k in atoms)
        return is_there and any(self.own[k] and self._backbone[k] is None for k in atoms)

    def add_terms(self, system: openmm.System, *, constrain: bool) -> None:
        """Adds bonds, angles and torsions; `constrain`: bonds of hydrogens are constraints."""
        for kind, atoms, values in self._terms():
            places = [int(self.where[k]) for k in atoms]
            if kind == "Bond" and constrain and any(self.is_hydrogen(k) for k in atoms):
                system.addConstraint(*places, values[0])
            else:
                getattr(force_of(system, FORCES[kind][0]), f"add{kind}")(*places, *values)

    def _terms(self) -> Iterator[tuple[str, list[int], list[Any]]]:
        """What kind, atoms of the topology, and values."""
        for kind, (force, count) in FORCES.items():
            own = force_of(self.system, force)
            for k in range(getattr(own, f"getNum{kind}s")()):
                found = getattr(own, f"get{kind}Parameters")(k)
                if self._is_added(found[:count]):
                    yield kind, found[:count], found[count:]

    def is_hydrogen(self, atom: int) -> bool:
        """Of the topology's atoms."""
        return bool(self._elements[atom] == 1)


def added_of(
    prmtop: bytes, where: np.ndarray, own: np.ndarray, names: list[str], name: str
) -> Added:
    """Of the text of an AMBER topology."""
    with tempfile.TemporaryDirectory(prefix="pliant-prmtop-") as folder:
        file = Path(folder, "ligand.prmtop")
        write_bytes(file, prmtop)
        read = app.AmberPrmtopFile(str(file))
    system = read.createSystem(nonbondedMethod=app.NoCutoff, removeCMMotion=False)
    return Added(name, where, own, names, read.topology, system)


def force_of(system: openmm.System, kind: type) -> Any:
    """The first force of a kind; one that is added where there is none."""
    found = next((force for force in system.getForces() if isinstance(force, kind)), None)
    if found is None:
        found = system.getForce(system.addForce(kind()))
    return found
