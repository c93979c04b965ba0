# SPDX-License-Identifier: MIT
"""A path: found by the library, shown as it comes nearer, written once it has ended."""

from __future__ import annotations

import os
import time
from collections.abc import Callable, Sequence
from typing import Literal

from pliant import _progress
from pliant._checked import SEED, checked
from pliant._core import H5mdRecorder, PathEnds, PathOptions, PathWalk, PdbRecorder, Structure
from pliant._output_names import check_trajectory_name, is_pdb_name
from pliant._trajectory.sources import Molecule, structure_of
from pliant.path.found import MolecularPath

__all__ = ["PathEnds", "PathOptions", "PathWalk", "find", "path"]

WHOLE = 100  #: of the distance, as bars show it: per cent


@checked(seed=SEED)
def path(
    start: Structure | Molecule,
    end: Structure | Molecule,
    *,
    atoms: Literal["CA", "heavy"] = "CA",
    step: float = 0.2,
    both: bool = False,
    backtrack: int = 0,
    seed: int = 0,
    keep: str | Sequence[str] = (),
    output: str | os.PathLike[str] | None = None,
    overwrite: bool = False,
) -> MolecularPath:
    """Moves a molecule towards another structure of itself, every frame whole.

    Parameters
    ----------
    start, end : Structure, path, Universe, AtomGroup, ...
        Molecules as `sample` takes them, of proteins or nucleic acids; matched by chain and
        number, else by sequence.
    atoms : str
        Which are asked to arrive: ``CA`` (P of nucleotides) or ``heavy``, those of matched residues
        that have the same name.
    step : float
        r.m.s. distance of a step, Angstrom, above 0, at most 2.
    both : bool
        Moves both structures towards each other first. Where they meet, or neither comes nearer,
        `start` goes on along the frames that `end` has made. All frames are of `start`, with its
        bars.
    backtrack : int
        How often to go back and try again by a detour where the path is stuck, 0 to 1000. What is
        not kept is not part of the path.
    seed : int
        Of the detours.
    keep : str or sequence of str
        Crystallisation additives to keep, as for `build_model`.
    output : str or path, optional
        H5MD file to write frames to, or a PDB file with one model for each, when all are made;
        those that there are after Ctrl-C.
    overwrite : bool
        Replace it.

    Raises
    ------
    OptionError
        An option out of range.
    InputError
        A file that cannot be read, or structures that do not match.
    FileError
        The output exists or cannot be written.
    """
    if output is not None:
        check_trajectory_name(output, "path")
    names = keep if isinstance(keep, str) else ",".join(keep)
    options = PathOptions(
        atoms=atoms, step=step, both=both, backtrack=backtrack, seed=seed, keep=names
    )
    bar = _progress.begin("path", WHOLE)
    try:
        return find(start, end, options, output, overwrite, bar.show if bar else None)
    finally:
        if bar is not None:
            bar.close()


def find(
    start: Structure | Molecule,
    end: Structure | Molecule,
    options: PathOptions,
    output: str | os.PathLike[str] | None = None,
    overwrite: bool = False,
    show: Callable[[int], None] | None = None,
) -> MolecularPath:
    """As `path`; calls `show` with how much of the distance is gone, out of WHOLE."""
    begun = time.perf_counter()
    ends = PathEnds(structure_of(start), structure_of(end), options)
    recorder = None if output is None else _recorder(ends, options, output, overwrite)
    walk = PathWalk(ends, options)
    try:
        _go(walk, show)
    finally:  # after Ctrl-C what there is of the path is written as well
        if isinstance(recorder, PdbRecorder):
            for frame in walk.positions():
                recorder.record(frame)
        elif recorder is not None:
            walk.record(recorder)
        if recorder is not None:
            recorder.close()
    atoms, contacts = options.atoms, len(ends.model.contacts)
    made = ends.model, walk.positions(), walk.table(), ends.matched, atoms, contacts
    found = MolecularPath(
        *made, ends.only_start, ends.only_end, walk.notes, walk.attempts, walk.turned
    )
    found.seconds = time.perf_counter() - begun
    return found


def _go(walk: PathWalk, show: Callable[[int], None] | None) -> None:
    """To where it ends."""
    whole = walk.left
    while walk.advance():
        if show is not None:
            show(max(0, round(WHOLE * (1 - walk.left / whole))))


def _recorder(
    ends: PathEnds, options: PathOptions, output: str | os.PathLike[str], overwrite: bool
) -> H5mdRecorder | PdbRecorder:
    if is_pdb_name(output):
        return PdbRecorder(os.fspath(output), ends.model.structure, overwrite=overwrite)
    end = {"path/end": os.path.basename(ends.source_of_end)}
    return H5mdRecorder(
        output,
        ends.model.framework,
        structure=ends.model.structure,
        parameters=end | options.parameters(),
        overwrite=overwrite,
    )
