# SPDX-License-Identifier: MIT
"""ProDy: atom groups with their coordinate sets."""

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
    import prody
else:
    prody = late("prody")


@checked(atoms=having("getCoordsets", "an AtomGroup or selection of ProDy"))
def from_prody(atoms: prody.AtomGroup) -> Structure:
    """Return atoms of ProDy, at the active coordinate set, as a structure.

    Bonds are those of `atoms`, if it has any, with orders by residue templates; else all are
    perceived, as in a file.

    Parameters
    ----------
    atoms : prody.AtomGroup, or a selection
        In Angstrom.
    """
    count = atoms.numAtoms()
    bonds = _bonds(atoms)
    structure = Structure(
        atoms.getCoords(),
        elements=_texts(atoms.getElements(), count, str.capitalize),
        names=_texts(atoms.getNames(), count),
        residue_names=_texts(atoms.getResnames(), count),
        residue_ids=atoms.getResnums(),
        insertion_codes=_texts(atoms.getIcodes(), count),
        chains=_texts(atoms.getChids(), count),
        serials=atoms.getSerials(),
        bonds=bonds,
        title=str(getattr(atoms, "getTitle", str)()),
    )
    structure.gather_residues()
    structure.perceive_bonds(guess_distances=bonds is None)  # ProDy knows no orders of bonds
    return structure


def prody_frames(atoms: Any) -> npt.NDArray[np.float64]:
    """(F, N, 3) Angstrom: all coordinate sets."""
    return np.asarray(atoms.getCoordsets(), dtype=np.float64)


def to_prody(source: Molecule | Structure) -> prody.AtomGroup:
    """Return an AtomGroup of ProDy with a coordinate set for each frame.

    Parameters
    ----------
    source : Structure, SampledEnsemble, Trajectory, path, ...
        What a `Trajectory` is made of.

    Raises
    ------
    ImportError
        ProDy is not installed; the message says how to install it.
    """
    need("pliant.to_prody", "prody")
    frames = Trajectory(source)
    structure = frames.structure
    atoms = prody.AtomGroup(structure.title or structure.source or "Pliant")
    atoms.setCoords(np.ascontiguousarray(frames.positions))
    atoms.setNames(structure.names)
    atoms.setElements(np.char.upper(structure.symbols))
    atoms.setResnames(structure.residue_names)
    atoms.setResnums(structure.residue_ids)
    atoms.setChids(structure.chains)
    atoms.setIcodes(structure.insertion_codes)
    atoms.setSerials(structure.serials)
    if len(structure.bonds):
        atoms.setBonds(structure.bonds.astype(np.int64))
    return atoms


def _texts(values: Any, count: int, made: Any = str) -> list[str] | None:
    if values is None or len(values) != count:
        return None
    return [made(str(value).strip()) for value in values]


def _bonds(atoms: Any) -> npt.NDArray[np.int64] | None:
    """(M, 2) pairs of places among `atoms`; None where ProDy knows none."""
    found = [bond.getIndices() for bond in atoms.iterBonds()] if _knows_bonds(atoms) else []
    if not found:
        return None
    is_part = hasattr(atoms, "getAtomGroup")
    indices = atoms.getIndices() if is_part else range(atoms.numAtoms())
    place = {int(index): k for k, index in enumerate(indices)}
    return np.array([[place[int(a)], place[int(b)]] for a, b in found], dtype=np.int64)


def _knows_bonds(atoms: Any) -> bool:
    group = atoms.getAtomGroup() if hasattr(atoms, "getAtomGroup") else atoms
    return group._bonds is not None
