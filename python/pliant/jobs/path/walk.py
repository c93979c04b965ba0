# SPDX-License-Identifier: MIT
"""A path: found by the library, shown as it comes nearer, written once it has ended."""

from __future__ import annotations

import os
import time
from collections.abc import Callable
from typing import Any

from pliant._core import H5mdRecorder, PathEnds, PathOptions, PathWalk, PdbRecorder, Structure, path
from pliant.base import progress as _progress
from pliant.base.checked import checked
from pliant.base.output_names import check_trajectory_name, is_pdb_name
from pliant.jobs.path.found import MolecularPath

__all__ = ["PathEnds", "PathOptions", "PathWalk", "find", "path"]

WHOLE = 100  #: of the distance, as bars show it: per cent


@checked()
def shown(
    start: Any,
    end: Any,
    options: PathOptions,
    output: str | os.PathLike[str] | None,
    overwrite: bool,
) -> MolecularPath:
    """What `path` does: as `find`, of any molecules, with a bar."""
    if output is not None:
        check_trajectory_name(output, "path")
    bar = _progress.begin("path", WHOLE)
    try:
        ends = options.start_of(start), options.end_of(end)
        return find(*ends, options, output, overwrite, bar.show if bar else None)
    finally:
        if bar is not None:
            bar.close()


def find(
    start: Structure,
    end: Structure,
    options: PathOptions,
    output: str | os.PathLike[str] | None = None,
    overwrite: bool = False,
    show: Callable[[int], None] | None = None,
) -> MolecularPath:
    """As `path`; calls `show` with how much of the distance is gone, out of WHOLE."""
    begun = time.perf_counter()
    ends = PathEnds(start, end, options)
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
    start = ends.model.structure
    files = {
        "path/end": os.path.basename(ends.source_of_end),
        "input/file": os.path.basename(start.source),
        "input/model": start.model,
    }
    return H5mdRecorder(
        output,
        ends.model.framework,
        structure=start,
        parameters=options.parameters() | files,
        overwrite=overwrite,
    )
