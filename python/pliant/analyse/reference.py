# SPDX-License-Identifier: MIT
"""The structure that frames are compared with: the one that a run or an ensemble began with."""

from __future__ import annotations

import warnings
from pathlib import Path
from typing import TYPE_CHECKING

import MDAnalysis
import numpy as np

from pliant._core import InputError
from pliant.analyse.found import Reference

if TYPE_CHECKING:
    from MDAnalysis import Universe

    from pliant.analyse.study import Study


def reference_of(study: Study) -> Reference:
    """The file that the options name; else the PDB that `pliant run` and `sample` write beside
    their trajectory; else the first frame. The study's notes say which, where it is the PDB.

    Raises InputError when the named file cannot be read or has other atoms.
    """
    named = study.options.reference
    if named is not None:
        return Reference(_same_atoms(study.universe, Path(named)), Path(named).name)
    beside = Path(study.options.path).with_suffix(".pdb")
    if study.record is not None and beside.is_file():
        try:
            positions = _same_atoms(study.universe, beside)
        except InputError as error:
            study.notes.append(f"not compared with the start structure: {error}")
        else:
            study.notes.append(f"compared with {beside.name}, the structure beside the trajectory")
            return Reference(positions, beside.name)
    return Reference(study.positions(0), "the first frame")


def _same_atoms(universe: Universe, path: Path) -> np.ndarray:
    """Positions of a structure file whose atoms are those of the universe."""
    if not path.is_file():
        raise InputError(f"{path}: no such file")
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        try:
            other = MDAnalysis.Universe(str(path))
        except Exception as error:  # MDAnalysis raises whatever its readers meet
            reason = " ".join(str(error).split()) or type(error).__name__
            raise InputError(f"{path}: MDAnalysis cannot read it: {reason}") from error
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
