# SPDX-License-Identifier: MIT
"""MDAnalysis: atoms of a universe as a structure, and a universe of a structure or framework."""

from __future__ import annotations

import warnings
from collections.abc import Callable
from typing import TYPE_CHECKING, Any, cast

import numpy as np
import numpy.typing as npt

from pliant._core import Framework, InputError, PliantWarning, Structure
from pliant.base.checked import POSITIVE, checked, having
from pliant.base.extras import late, need
from pliant.trajectory.chains import chain_of
from pliant.trajectory.frames import FramesInMemory
from pliant.trajectory.sources import Molecule
from pliant.trajectory.trajectory import Trajectory

if TYPE_CHECKING:
    import MDAnalysis
else:
    MDAnalysis = late("MDAnalysis")

exceptions = late("MDAnalysis.exceptions")
guesser, old_guesser = map(
    late, ("MDAnalysis.guesser.default_guesser", "MDAnalysis.topology.guessers")
)
mdamath = late("MDAnalysis.lib.mdamath")
memory = late("MDAnalysis.coordinates.memory")
universes = late("pliant.trajectory.universe")

#: What MDAnalysis and the formats it reads call an aromatic bond.
_AROMATIC = {"ar", "aromatic", "1.5"}


@checked(atoms=having("atoms", 'a Universe or an AtomGroup, such as MDAnalysis.Universe("x.pdb")'))
def from_mdanalysis(
    atoms: MDAnalysis.Universe | MDAnalysis.AtomGroup, *, perceive_bonds: bool | None = None
) -> Structure:
    """Return the atoms of a universe or group, at the current frame, as a structure.

    Parameters
    ----------
    atoms : Universe or AtomGroup
        In Angstrom, as everywhere in MDAnalysis, whose positions are 32-bit floats. Molecules that
        the box of the frame cuts are made whole.
    perceive_bonds : bool, optional
        Add bonds by residue templates, links and distances. Default: only if the universe has
        no bonds at all.

    Warns
    -----
    PliantWarning
        The universe has no elements: they are guessed from names, as MDAnalysis does.
    """
    need("pliant.from_mdanalysis", "MDAnalysis")
    group = atoms.atoms
    bonds, orders = _bonds_within(group)
    structure = Structure(
        group.positions,
        elements=_elements(group),
        names=_texts(group, "names"),
        residue_names=_texts(group, "resnames"),
        residue_ids=group.resids if hasattr(group, "resids") else None,
        insertion_codes=_texts(group, "icodes"),
        chains=_chains(group),
        serials=group.ids if hasattr(group, "ids") else None,
        bonds=bonds,
        bond_orders=orders,
    )
    structure.cell = _cell(group)
    structure.gather_residues()
    if perceive_bonds or (perceive_bonds is None and bonds is None):
        structure.perceive_bonds()
    else:
        structure.make_whole()
    return structure


@checked(timestep=POSITIVE)
def to_mdanalysis(
    source: Structure | Framework | Molecule,
    positions: npt.ArrayLike | None = None,
    *,
    timestep: float = 1.0,
) -> MDAnalysis.Universe:
    """Return a universe with names, residues and bonds; for a framework, bars become bonds.

    Parameters
    ----------
    source : Structure, Framework, SampledEnsemble, Trajectory, path, ...
        A framework, or what a `Trajectory` is made of.
    positions : (N, 3) or (F, N, 3) Angstrom, optional
        One frame or several, kept in memory. Default: all of `source`.
    timestep : float
        Time between frames in ps.

    Raises
    ------
    ImportError
        MDAnalysis is not installed; the message says how to install it.
    """
    need("pliant.to_mdanalysis", "MDAnalysis")
    if isinstance(source, Framework):
        if positions is None:
            raise TypeError("to_mdanalysis: a framework has no positions: give them")
        universe, frames = _universe_of_framework(source), _frames(positions, source.joint_count)
    else:
        trajectory = Trajectory(source, positions)
        frames = trajectory.positions
        named = FramesInMemory(trajectory.structure, frames)
        universe = MDAnalysis.Universe(universes.topology_of(named))
    universe.load_new(np.array(frames), format=memory.MemoryReader, order="fac", dt=timestep)
    return universe


def _cell(group: Any) -> npt.NDArray[np.float64] | None:
    """Edges of the box; None where the frame has none."""
    box = group.dimensions
    return None if box is None else mdamath.triclinic_vectors(box, dtype=np.float64)


def _texts(group: Any, name: str) -> list[str] | None:
    return [str(text) for text in getattr(group, name)] if hasattr(group, name) else None


def _chains(group: Any) -> list[str] | None:
    chains = _texts(group, "chainIDs")
    if chains is not None and any(chains):
        return chains
    segments = _texts(group, "segids")
    return segments and [chain_of(name) for name in segments]


def _elements(group: Any) -> list[str] | None:
    elements = _texts(group, "elements")
    if elements is not None and any(elements):
        return elements
    names = _texts(group, "names") or _texts(group, "types")
    if names is None:
        return None
    guess = _guesser()
    guessed = ["" if element == "DUMMY" else element for element in map(guess, names)]
    warnings.warn("the universe has no elements: guessed from names", PliantWarning, stacklevel=4)
    return guessed


def _guesser() -> Callable[[str], str]:
    """MDAnalysis' own guess of an element from an atom's name."""
    try:
        return cast("Callable[[str], str]", guesser.DefaultGuesser(None).guess_atom_element)
    except ImportError:  # before 2.8
        return cast("Callable[[str], str]", old_guesser.guess_atom_element)


def _bonds_within(group: Any) -> tuple[npt.NDArray[np.int64] | None, list[int] | None]:
    """Bonds between atoms of the group as pairs of places in it; None if no bonds are known."""
    try:
        bonds = group.bonds
    except (AttributeError, exceptions.NoDataError):
        return None, None
    place = np.full(len(group.universe.atoms), -1)
    place[group.indices] = np.arange(len(group))
    pairs = place[np.asarray(bonds.indices).reshape(-1, 2)]
    inside = (pairs >= 0).all(axis=1)
    orders = [_order(bond.order) for bond in bonds] if len(bonds) and bonds[0].order else None
    if orders is not None:
        orders = [order for order, kept in zip(orders, inside, strict=True) if kept]
    return pairs[inside], orders


def _order(order: object) -> int:
    text = str(order).lower()
    if text in _AROMATIC:
        return 4
    return int(float(text)) if text in {"1", "2", "3", "1.0", "2.0", "3.0"} else 0


def _frames(positions: npt.ArrayLike, count: int) -> npt.NDArray[np.float64]:
    frames = np.array(positions, dtype=np.float64)
    if frames.ndim == 2:
        frames = frames[np.newaxis]
    if frames.ndim != 3 or frames.shape[1:] != (count, 3):
        raise InputError(
            f"positions: expected shape ({count}, 3) or (F, {count}, 3), "
            f"found {np.shape(positions)}"
        )
    return frames


def _universe_of_framework(framework: Framework) -> MDAnalysis.Universe:
    count = framework.joint_count
    universe = MDAnalysis.Universe.empty(count, trajectory=True)
    universe.add_TopologyAttr("names", [framework.label(i) for i in range(count)])
    inverse = framework.inverse_masses
    masses = np.divide(1.0, inverse, out=np.zeros(count), where=inverse > 0)
    universe.add_TopologyAttr("masses", masses)
    universe.add_TopologyAttr("bonds", framework.bars.astype(np.int64))
    return universe
