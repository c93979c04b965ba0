# SPDX-License-Identifier: MIT
"""OpenMM: topologies as structures, constraints as bars; converts from nanometres."""

from __future__ import annotations

import warnings
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from pliant._checked import checked, having
from pliant._core import Framework, PliantWarning, Structure
from pliant._extras import need

if TYPE_CHECKING:
    import openmm
    import openmm.app

_ANGSTROM_PER_NM = 10.0


@checked(topology=having("atoms", "an openmm.app.Topology"))
def from_openmm(
    topology: openmm.app.Topology, positions: Any, *, perceive_bonds: bool | None = None
) -> Structure:
    """Return an OpenMM topology with positions as a structure.

    Parameters
    ----------
    topology : openmm.app.Topology
    positions : Quantity, or (N, 3) numbers in nm
        As everywhere in OpenMM; they are converted to Angstrom. Molecules that the topology's box
        cuts are made whole.
    perceive_bonds : bool, optional
        Add bonds by residue templates, links and distances. Default: only if the topology has
        no bonds at all.

    Warns
    -----
    PliantWarning
        The id of some residue is not a number: all residues are then numbered from 1.
    """
    need("pliant.from_openmm", "openmm")
    atoms = list(topology.atoms())
    bonds = list(topology.bonds())
    structure = Structure(
        _angstroms(positions),
        elements=[atom.element.atomic_number if atom.element else 0 for atom in atoms],
        names=[atom.name for atom in atoms],
        residue_names=[atom.residue.name for atom in atoms],
        residue_ids=_residue_ids(topology, atoms),
        insertion_codes=[atom.residue.insertionCode.strip() for atom in atoms],
        chains=[atom.residue.chain.id.strip() for atom in atoms],
        serials=_serials(atoms),
        bonds=[(bond.atom1.index, bond.atom2.index) for bond in bonds],
        bond_orders=[_order(bond) for bond in bonds],
    )
    structure.cell = _cell(topology)
    if perceive_bonds or (perceive_bonds is None and not bonds):
        structure.perceive_bonds()
    else:
        structure.make_whole()
    return structure


@checked(system=having("getNumParticles", "an openmm.System"))
def constraints_from_openmm(system: openmm.System, structure: Structure | None = None) -> Framework:
    """Return the framework whose bars are the distance constraints of an OpenMM system.

    Parameters
    ----------
    system : openmm.System
        Constrained distances become rest lengths in Angstrom, masses stay in u. Particles
        without a mass, which OpenMM never moves, become pinned joints.
    structure : Structure, optional
        The structure whose atoms the particles are; it names them in messages and files.
    """
    need("pliant.constraints_from_openmm", "openmm")
    from openmm import unit

    count = system.getNumParticles()
    masses = np.array([system.getParticleMass(i).value_in_unit(unit.dalton) for i in range(count)])
    constraints = [system.getConstraintParameters(k) for k in range(system.getNumConstraints())]
    return Framework(
        [(first, second) for first, second, _ in constraints],
        [length.value_in_unit(unit.angstrom) for *_, length in constraints],
        count,
        masses=np.where(masses > 0, masses, 1.0),
        pinned=masses == 0,
        structure=structure,
    )


def _angstroms(positions: Any) -> npt.NDArray[np.float64]:
    from openmm import unit

    if unit.is_quantity(positions):
        return np.array(positions.value_in_unit(unit.angstrom), dtype=np.float64)
    if len(positions) > 0 and unit.is_quantity(positions[0]):
        return np.array([x.value_in_unit(unit.angstrom) for x in positions], dtype=np.float64)
    return np.array(positions, dtype=np.float64) * _ANGSTROM_PER_NM


def _cell(topology: openmm.app.Topology) -> npt.NDArray[np.float64] | None:
    """Edges of the box; None where the topology has none."""
    edges = topology.getPeriodicBoxVectors()
    return None if edges is None else _angstroms(edges)


def _residue_ids(topology: openmm.app.Topology, atoms: list[Any]) -> list[int]:
    try:
        return [int(atom.residue.id) for atom in atoms]
    except ValueError:
        odd = next(r.id for r in topology.residues() if not r.id.lstrip("-").isdigit())
        warnings.warn(
            f"residue id {odd!r} is no number: residues are numbered from 1",
            PliantWarning,
            stacklevel=4,
        )
        return [atom.residue.index + 1 for atom in atoms]


def _serials(atoms: list[Any]) -> list[int] | None:
    try:
        return [int(atom.id) for atom in atoms]
    except ValueError:
        return None


def _order(bond: Any) -> int:
    if bond.type is not None and str(bond.type) == "Aromatic":
        return 4
    return bond.order or 0
