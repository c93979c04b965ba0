# SPDX-License-Identifier: MIT
"""Which atom of their trajectory is which of ours."""

from __future__ import annotations

import os
import warnings
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from MDAnalysis.exceptions import SelectionError

from pliant._core import InputError
from pliant.trajectory.opened import is_recorded
from pliant.trajectory.universe import nameless_count, open_frames, open_universe

if TYPE_CHECKING:
    from MDAnalysis import AtomGroup, Universe
    from MDAnalysis.core.groups import Atom


@dataclass
class Pairing:
    """The chosen atoms of both, in the sequence of ours."""

    ours: AtomGroup
    theirs: AtomGroup
    how: str  #: how they were matched, for the report


def open_theirs(
    path: str | os.PathLike[str], topology: str | os.PathLike[str] | None, ours: Universe
) -> tuple[Universe, bool]:
    """Their universe, and whether its atoms are named by a file of theirs.

    Without a topology a trajectory that holds no names (DCD, XTC) gets the atoms of ours, if they
    are as many.
    """
    if topology is not None or is_recorded(path):
        return open_frames(path, topology)[1], True
    count = nameless_count(path)
    if count is None:
        return open_universe(path), True
    if count != len(ours.atoms):
        raise InputError(
            f"{os.fspath(path)}: has {count} atoms and ours has {len(ours.atoms)}: give a "
            "--topology that names its atoms, and choose the same of both with --select"
        )
    theirs = ours.copy()
    theirs.load_new(os.fspath(path))
    return theirs, False


def choose(universe: Universe, selection: str, path: str | os.PathLike[str]) -> AtomGroup:
    """Atoms of a selection. Raises InputError if it is wrong or there are none."""
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            atoms = universe.select_atoms(selection)
    except (SelectionError, AttributeError, ValueError, TypeError) as error:
        raise InputError(f"--select '{selection}': {' '.join(str(error).split())}") from error
    if len(atoms) == 0:
        raise InputError(f"{os.fspath(path)}: --select '{selection}' chooses no atom")
    return atoms


def pair(ours: AtomGroup, theirs: AtomGroup, named: bool = True) -> Pairing:
    """Matches atoms by residue and name, or by order if only the names differ.

    Raises InputError naming both counts, or the first atom that fits none.
    """
    if len(ours) != len(theirs):
        raise InputError(_different_counts(ours, theirs))
    if not named:
        return Pairing(ours, theirs, "by order: their file has no names")
    our_keys, their_keys = _keys(ours), _keys(theirs)
    if our_keys == their_keys:
        return Pairing(ours, theirs, "by order; residues and names agree")
    if len(set(our_keys)) == len(our_keys) and set(our_keys) == set(their_keys):
        place = {key: k for k, key in enumerate(their_keys)}
        order = [place[key] for key in our_keys]
        return Pairing(ours, theirs[order], "by residue and name; the order differs")
    return _pair_by_order(ours, theirs)


def _pair_by_order(ours: AtomGroup, theirs: AtomGroup) -> Pairing:
    for k, (a, b) in enumerate(zip(*_elements(ours, theirs), strict=True)):
        if a != b:
            raise InputError(
                f"both have {len(ours)} atoms, but atom {k} is {_label(ours[k])} in ours and "
                f"{_label(theirs[k])} in theirs"
            )
    differing = np.flatnonzero([a.name != b.name for a, b in zip(ours, theirs, strict=True)])
    how = "by order; elements agree"
    if len(differing):
        k = differing[0]
        how += f", {len(differing)} names do not (the first: {ours[k].name}, {theirs[k].name})"
    return Pairing(ours, theirs, how)


def _keys(atoms: AtomGroup) -> list[tuple[int, str]]:
    """Place of the residue among those chosen, and name: numbering and chains may differ."""
    _, residue = np.unique(atoms.resindices, return_inverse=True)
    return list(zip(residue.tolist(), map(str, _names(atoms)), strict=True))


def _names(atoms: AtomGroup) -> list[str]:
    return list(atoms.names) if hasattr(atoms, "names") else [""] * len(atoms)


def _elements(ours: AtomGroup, theirs: AtomGroup) -> tuple[list[str], list[str]]:
    """Elements in capitals; unless both have them, the first letters of the names."""
    if all(hasattr(atoms, "elements") and all(atoms.elements) for atoms in (ours, theirs)):
        return [e.upper() for e in ours.elements], [e.upper() for e in theirs.elements]
    first, second = (
        [name.lstrip("0123456789")[:1].upper() for name in _names(atoms)]
        for atoms in (ours, theirs)
    )
    return first, second


def _label(atom: Atom) -> str:
    residue = f"{getattr(atom, 'resname', '')}{getattr(atom, 'resid', '')}"
    return f"{residue}:{getattr(atom, 'name', atom.index)}"


def _different_counts(ours: AtomGroup, theirs: AtomGroup) -> str:
    counts = f"ours has {len(ours)} atoms and theirs {len(theirs)}"
    text = f"{counts}: choose the same of both with --select"
    more, less, whose = (
        (ours, theirs, "ours") if len(ours) > len(theirs) else (theirs, ours, "theirs")
    )
    known = set(_keys(less))
    extra = [atom for key, atom in zip(_keys(more), more, strict=True) if key not in known]
    if extra:
        text += f" (only {whose} has {_label(extra[0])}"
        text += f" and {len(extra) - 1} more)" if len(extra) > 1 else ")"
    return text
