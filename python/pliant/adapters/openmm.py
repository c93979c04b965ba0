# SPDX-License-Identifier: MIT
"""OpenMM: topologies as structures, constraints as bars; converts from nanometres."""

from __future__ import annotations

import warnings
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from pliant._core import Framework, InputError, PliantWarning, Structure
from pliant.base.checked import Wanted, checked, having
from pliant.base.extras import late, need
from pliant.trajectory.sources import Molecule
from pliant.trajectory.trajectory import Trajectory

if TYPE_CHECKING:
    import openmm
    import openmm.app

app = late("openmm.app")
unit = late("openmm.unit")

_ANGSTROM_PER_NM = 10.0


_SOURCE = Wanted(
    "an openmm.app.Topology, or a Modeller, PDBFile or Simulation",
    lambda x: hasattr(x, "atoms") or hasattr(x, "topology"),
    TypeError,
)


@checked(topology=_SOURCE)
def from_openmm(
    topology: openmm.app.Topology | openmm.app.Modeller,
    positions: Any = None,
    *,
    perceive_bonds: bool | None = None,
) -> Structure:
    """Return an OpenMM topology with positions as a structure.

    Parameters
    ----------
    topology : openmm.app.Topology
        Or a Modeller, PDBFile, PDBxFile or Simulation, which has positions.
    positions : Quantity, or (N, 3) numbers in nm, optional
        As everywhere in OpenMM; they are converted to Angstrom. Molecules that the topology's box
        cuts are made whole. Default: those of `topology`.
    perceive_bonds : bool, optional
        Add bonds by residue templates, links and distances. Default: only if the topology has
        no bonds at all.

    Warns
    -----
    PliantWarning
        The id of some residue is not a number: all residues are then numbered from 1.
    """
    need("pliant.from_openmm", "openmm")
    if positions is None:
        topology, positions = _opened(topology)
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


def to_openmm(source: Molecule | Structure, frame: int = 0) -> openmm.app.Modeller:
    """Return an openmm.app.Modeller: a topology with the positions of one frame.

    Parameters
    ----------
    source : Structure, SampledEnsemble, Trajectory, path, ...
        What a `Trajectory` is made of.
    frame : int
        Which of its frames, from 0; negative ones count from the end.

    Raises
    ------
    ImportError
        OpenMM is not installed; the message says how to install it.
    """
    need("pliant.to_openmm", "openmm")
    frames = Trajectory(source)
    positions = frames[frame] / _ANGSTROM_PER_NM
    return app.Modeller(_topology(frames.structure), positions * unit.nanometer)


def _topology(structure: Structure) -> Any:
    kinds = {1: app.Single, 2: app.Double, 3: app.Triple, 4: app.Aromatic}
    topology = app.Topology()
    chain = residue = None
    before: tuple[str | None, int] = (None, -1)
    chains, names, residue_ids = structure.chains, structure.names, structure.residue_ids
    for k, here in enumerate(structure.residue_of.tolist()):
        if chains[k] != before[0]:
            chain = topology.addChain(str(chains[k]))
        if (chains[k], here) != before:
            name, code = str(structure.residue_names[k]), str(structure.insertion_codes[k])
            residue = topology.addResidue(name, chain, str(residue_ids[k]), code)
        before = (chains[k], here)
        number = int(structure.elements[k])
        element = app.Element.getByAtomicNumber(number) if number else None
        topology.addAtom(str(names[k]), element, residue, str(structure.serials[k]))
    atoms = list(topology.atoms())
    for (a, b), order in zip(structure.bonds.tolist(), structure.bond_orders.tolist(), strict=True):
        topology.addBond(
            atoms[a], atoms[b], kinds.get(order), order if order in (1, 2, 3) else None
        )
    return topology


def _opened(given: Any) -> tuple[Any, Any]:
    """The topology and the positions of an object of OpenMM that has both."""
    if hasattr(given, "positions"):
        return given.topology, given.positions
    if hasattr(given, "context"):
        return given.topology, given.context.getState(getPositions=True).getPositions()
    raise InputError(
        "the topology has no positions: pliant.from_openmm(pdb.topology, pdb.positions)"
    )


def _angstroms(positions: Any) -> npt.NDArray[np.float64]:
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
