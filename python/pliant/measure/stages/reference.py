# SPDX-License-Identifier: MIT
"""The structure that frames are compared with: the one that a run or an ensemble began with."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from pliant._core import InputError
from pliant.base.output_names import start_beside
from pliant.measure.stages.parts import ReferenceStructure
from pliant.trajectory.opened import is_recorded
from pliant.trajectory.universe import open_universe

if TYPE_CHECKING:
    from MDAnalysis import Universe

    from pliant.measure.stages.analysis import Analysis


FIRST = "the first frame"


def reference_of(analysis: Analysis) -> ReferenceStructure:
    """The file that the options name; else the PDB that `pliant run` and `sample` write beside
    their trajectory; else the first frame.

    Raises InputError when the named file cannot be read or has other atoms.
    """
    named = analysis.options.reference
    if named is not None:
        return ReferenceStructure(_same_atoms(analysis.universe, Path(named)), Path(named).name)
    beside, first = start_beside(analysis.options.path), analysis.positions(0)
    if not is_recorded(analysis.options.path) or not beside.is_file():
        return ReferenceStructure(first, FIRST)
    try:
        positions = _same_atoms(analysis.universe, beside)
    except InputError as error:
        notes = (f"not compared with the start structure: {error}",)
        return ReferenceStructure(first, FIRST, notes=notes, cautions=notes)
    note = f"compared with {beside.name}, the structure beside the trajectory"
    return ReferenceStructure(positions, beside.name, notes=(note,))


def _same_atoms(universe: Universe, path: Path) -> np.ndarray:
    """Positions of a structure file whose atoms are those of the universe."""
    other = open_universe(path)
    ours, theirs = universe.atoms, other.atoms
    if len(ours) != len(theirs):
        raise InputError(f"{path}: expected {len(ours)} atoms, found {len(theirs)}")
    if hasattr(ours, "names") and hasattr(theirs, "names"):
        unlike = np.flatnonzero(np.asarray(ours.names) != np.asarray(theirs.names))
        if len(unlike):
            k = int(unlike[0])
            raise InputError(
                f"{path}: atom {k}: expected '{ours.names[k]}', found '{theirs.names[k]}'"
            )
    positions: np.ndarray = theirs.positions.astype(np.float64)
    return positions
