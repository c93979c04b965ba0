# SPDX-License-Identifier: MIT
"""Which atom of their trajectory is which of ours."""

from __future__ import annotations

import os
import warnings
from dataclasses import dataclass
from typing import TYPE_CHECKING

import h5py
import numpy as np

from pliant._core import InputError
from pliant.base.input_files import expect_file
from pliant.trajectory import hdf5 as _hdf5

if TYPE_CHECKING:
    from MDAnalysis import AtomGroup, Universe
    from MDAnalysis.core.groups import Atom


@dataclass
class Pairing:
    """The chosen atoms of both, in the sequence of ours."""

    ours: AtomGroup
    theirs: AtomGroup
    how: str  #: how they were matched, for the report


def open_universe(*files: str | os.PathLike[str]) -> Universe:
    """A universe of files that are there. Raises InputError in one line when it cannot be made."""
    import MDAnalysis

    import pliant.trajectory.h5md_parser
    import pliant.trajectory.shards.reader  # noqa: F401  # both open files of ours

    for file in files:
        if not os.path.exists(file):
            raise InputError(f"{os.fspath(file)}: no such file")
        expect_file(file)
        if os.path.isfile(file) and os.path.getsize(file) == 0:
            raise InputError(f"{os.fspath(file)}: is empty")
        if h5py.is_hdf5(file):
            _hdf5.open_file(file).close()  # looked at before MDAnalysis reads it
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # of missing masses and the like
            return MDAnalysis.Universe(*(os.fspath(file) for file in files))
    except Exception as error:  # each of MDAnalysis' readers has its own kinds
        names = " with ".join(os.fspath(file) for file in files)
        raise InputError(f"{names}: MDAnalysis cannot read this: {_one_line(error)}") from error


def _one_line(error: Exception) -> str:
    text = " ".join(str(error).split())
    return text if len(text) <= 200 else f"{text[:200]}..."


def open_theirs(
    path: str | os.PathLike[str], topology: str | os.PathLike[str] | None, ours: Universe
) -> tuple[Universe, bool]:
    """Their universe, and whether its atoms are named by a file of theirs.

    Without a topology a trajectory that holds no names (DCD, XTC) gets the atoms of ours, if they
    are as many.
    """
    if topology is not None:
        return open_universe(topology, path), True
    if not os.path.exists(path):
        raise InputError(f"{os.fspath(path)}: no such file")
    count = _nameless_count(os.fspath(path))
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


def _nameless_count(path: str) -> int | None:
    """Atoms of a trajectory whose format has no names; None if it has, or is unknown."""
    from MDAnalysis.coordinates.core import get_reader_for
    from MDAnalysis.core._get_readers import get_parser_for
    from MDAnalysis.topology.MinimalParser import MinimalParser

    try:
        if get_parser_for(path) is not MinimalParser:
            return None
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            with get_reader_for(path)(path) as reader:
                return int(reader.n_atoms)
    except Exception as error:  # each of MDAnalysis' readers has its own kinds
        message = f"{path}: MDAnalysis cannot read this: {_one_line(error)}"
        raise InputError(message) from error


def choose(universe: Universe, selection: str, path: str | os.PathLike[str]) -> AtomGroup:
    """Atoms of a selection. Raises InputError if it is wrong or there are none."""
    from MDAnalysis.exceptions import SelectionError

    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            atoms = universe.select_atoms(selection)
    except (SelectionError, AttributeError, ValueError, TypeError) as error:
        raise InputError(f"--select '{selection}': {_one_line(error)}") from error
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
