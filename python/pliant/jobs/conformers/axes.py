# SPDX-License-Identifier: MIT
"""Axes that cannot turn (atropisomers), and their hands, P or M."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
import numpy.typing as npt

from pliant import _core
from pliant._core import InputError, Structure
from pliant.base.extras import is_there, late
from pliant.jobs.conformers.hydrogens import numbered

if TYPE_CHECKING:
    from rdkit.Chem import Bond, Mol

Chem = late("rdkit.Chem")
rdCIPLabeler = late("rdkit.Chem.rdCIPLabeler")

OTHER = {"P": "M", "M": "P"}


@dataclass(frozen=True)
class Axis:
    """A bond between two crowded rings."""

    name: str  #: "C7-N9"
    torsion: tuple[int, int, int, int]  #: atoms; the bond is that of the second and third
    positive: str  #: the hand where the torsion is above 0: "P" or "M"

    def hand(self, positions: npt.NDArray[np.float64]) -> str:
        """P or M, of (N, 3)."""
        return self.positive if _sign(self.torsion, positions) > 0 else OTHER[self.positive]


def axes_of(structure: Structure, molecule: Callable[[], Mol]) -> list[Axis]:
    """Those of a molecule that have two hands. None without RDKit, which names them.

    `molecule` makes that of RDKit.
    """
    found = _core._atropisomer_axes(structure)  # type: ignore[attr-defined]
    if not found or not is_there("rdkit"):
        return []
    labels, here = numbered(structure.symbols), np.asarray(structure.positions)
    try:
        named = _labelled(molecule(), [(a, b) for _, a, b, _ in found])
    except InputError:  # RDKit does not accept the molecule
        return []
    axes = []
    for torsion in found:
        _, a, b, _ = torsion
        hand = _hand(named.GetBondBetweenAtoms(a, b))
        if hand:
            positive = hand if _sign(torsion, here) > 0 else OTHER[hand]
            axes.append(Axis(f"{labels[a]}-{labels[b]}", torsion, positive))
    return axes


def hands_text(axes: list[Axis], positions: npt.NDArray[np.float64]) -> str:
    """ "C8-N9 M", of one conformer (N, 3)."""
    return ", ".join(f"{one.name} {one.hand(positions)}" for one in axes)


def are_given(molecule: Mol) -> bool:
    """Whether a drawing or SMILES gives the hand of an axis."""
    return any("ATROP" in str(bond.GetStereo()) for bond in molecule.GetBonds())


def said_of(axes: list[Axis], here: npt.NDArray[np.float64], *, is_open: bool) -> list[str]:
    """A line for each axis of a molecule that is `here` (N, 3)."""
    if is_open:
        return [f"axis {one.name} cannot turn, no hand is given: P and M are made" for one in axes]
    return [f"axis {one.name} cannot turn: it stays {one.hand(here)}" for one in axes]


def _labelled(molecule: Mol, bonds: list[tuple[int, int]]) -> Mol:
    """A copy with CIP labels of the axes. Their hands are read from a record with wedges, which
    RDKit makes of the positions where a bond is marked with any hand."""
    marked = Chem.Mol(molecule)
    for a, b in bonds:
        marked.GetBondBetweenAtoms(a, b).SetStereo(Chem.BondStereo.STEREOATROPCW)
    read: Mol = Chem.MolFromMolBlock(Chem.MolToMolBlock(marked), removeHs=False)
    if read is None:
        raise InputError("RDKit does not accept the molecule")
    rdCIPLabeler.AssignCIPLabels(read)
    return read


def _hand(bond: Bond) -> str:
    """P or M; "" where both sides of a ring are alike."""
    label = bond.GetProp("_CIPCode") if bond.HasProp("_CIPCode") else ""
    return label.upper() if label.upper() in OTHER else ""


def _sign(torsion: tuple[int, int, int, int], positions: npt.NDArray[np.float64]) -> float:
    """That of a torsion."""
    one, axis, other = np.diff(positions[list(torsion)], axis=0)
    return float(np.cross(one, axis) @ other)
