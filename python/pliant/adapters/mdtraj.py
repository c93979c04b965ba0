# SPDX-License-Identifier: MIT
"""MDTraj: trajectories with their topology; converts from nanometres."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from pliant._core import Structure
from pliant.base.checked import checked, having
from pliant.base.extras import late, need
from pliant.trajectory.sources import Molecule
from pliant.trajectory.trajectory import Trajectory

if TYPE_CHECKING:
    import mdtraj
else:
    mdtraj = late("mdtraj")

_ANGSTROM_PER_NM = 10.0


@checked(trajectory=having("xyz", "an mdtraj.Trajectory"))
def from_mdtraj(trajectory: mdtraj.Trajectory) -> Structure:
    """Return the first frame of a trajectory of MDTraj as a structure.

    Bonds are those of its topology, if it has any; else they are perceived, as in a file.

    Parameters
    ----------
    trajectory : mdtraj.Trajectory
        In nm, as everywhere in MDTraj; positions are converted to Angstrom.
    """
    topology = trajectory.topology
    atoms, bonds = list(topology.atoms), list(topology.bonds)
    structure = Structure(
        mdtraj_frames(trajectory)[0],
        elements=[atom.element.atomic_number if atom.element else 0 for atom in atoms],
        names=[atom.name for atom in atoms],
        residue_names=[atom.residue.name for atom in atoms],
        residue_ids=[atom.residue.resSeq for atom in atoms],
        chains=[str(atom.residue.chain.chain_id or "") for atom in atoms],
        serials=[k + 1 if atom.serial is None else atom.serial for k, atom in enumerate(atoms)],
        bonds=[(a.index, b.index) for a, b in bonds] or None,
        bond_orders=[int(bond.order or 0) for bond in bonds] if bonds else None,
    )
    structure.gather_residues()
    if not bonds:
        structure.perceive_bonds()
    return structure


def mdtraj_frames(trajectory: Any) -> npt.NDArray[np.float64]:
    """(F, N, 3) Angstrom."""
    return np.asarray(trajectory.xyz, dtype=np.float64) * _ANGSTROM_PER_NM


def to_mdtraj(source: Molecule | Structure) -> mdtraj.Trajectory:
    """Return a trajectory of MDTraj, in nm and 32-bit floats, as everywhere there.

    Parameters
    ----------
    source : Structure, SampledEnsemble, Trajectory, path, ...
        What a `Trajectory` is made of.

    Raises
    ------
    ImportError
        MDTraj is not installed; the message says how to install it.
    """
    need("pliant.to_mdtraj", "mdtraj")
    frames = Trajectory(source)
    return mdtraj.Trajectory(frames.positions / _ANGSTROM_PER_NM, _topology(frames.structure))


def _topology(structure: Structure) -> Any:
    topology = mdtraj.Topology()
    chains, residue_ids = structure.chains, structure.residue_ids
    names, residue_names = structure.names, structure.residue_names
    chain = residue = None
    before: tuple[str | None, int] = (None, -1)
    for k, here in enumerate(structure.residue_of.tolist()):
        if chains[k] != before[0]:
            chain = topology.add_chain(str(chains[k]))
        if (chains[k], here) != before:
            residue = topology.add_residue(str(residue_names[k]), chain, int(residue_ids[k]))
        before = (chains[k], here)
        element = mdtraj.element.Element.getByAtomicNumber(int(structure.elements[k]))
        topology.add_atom(str(names[k]), element, residue, serial=int(structure.serials[k]))
    atoms = list(topology.atoms)
    for (a, b), order in zip(structure.bonds.tolist(), structure.bond_orders.tolist(), strict=True):
        topology.add_bond(atoms[a], atoms[b], order=order if order in (1, 2, 3) else None)
    return topology
