# SPDX-License-Identifier: MIT
"""Measures coverage: frames from one structure of a pair alone, the nearest to the other."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Sequence
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path

import numpy as np

from pliant._core import Error
from pliant.lab.coverage.directions import Direction, Judge, directions_of
from pliant.lab.coverage.ensembles import ENSEMBLES, Ensemble, Subject
from pliant.lab.coverage.rows import Coverage, Nearest, Share
from pliant.measure.agreement import bootstrap

DISTANCES = ((0.0, 5.0), (5.0, 8.0), (8.0, math.inf))  #: Angstrom between the two structures
DRAWS = 1000


def coverage(
    folder: str | Path,
    ensembles: Sequence[str] = (),
    frames: Sequence[int] = (200, 1000),
    *,
    seed: int = 0,
    processes: int = 1,
    progress: Callable[[int, int], object] | None = None,
) -> Coverage:
    """All directions of a folder (see ``directions_of``); ensembles by name, all if none is given.

    Raises InputError where the folder holds no pair. A direction that cannot be measured is named
    in ``skipped``.
    """
    directions = directions_of(Path(folder))
    chosen = [one for one in ENSEMBLES if not ensembles or one.name in ensembles]
    found = Coverage()
    names = [one.name for one in chosen]
    for done, part in enumerate(_each(directions, names, frames, seed, processes), start=1):
        found.directions += part.directions
        found.skipped += part.skipped
        if progress:
            progress(done, len(directions))
    for kind in dict.fromkeys(row.kind for row in found.directions):
        for count in frames:
            for one in chosen:
                found.shares += _shares(found.directions, kind, one, count)
    return found


def _each(
    directions: list[Direction], names: list[str], frames: Sequence[int], seed: int, processes: int
) -> Iterable[Coverage]:
    """What is found of each direction, in their order."""
    if processes == 1:
        return (_of_direction(one, names, frames, seed) for one in directions)
    pool = ProcessPoolExecutor(processes)
    count = len(directions)
    return pool.map(_of_direction, directions, [names] * count, [frames] * count, [seed] * count)


def _of_direction(
    direction: Direction, names: list[str], frames: Sequence[int], seed: int
) -> Coverage:
    """All ensembles of one direction, or the reason why there are none."""
    try:
        subject = Subject.of(direction.start)
        judge = Judge(direction, subject.model.structure)
        chosen = [one for one in ENSEMBLES if one.name in names]
        rows = [_nearest(judge, subject, one, count, seed) for one in chosen for count in frames]
    except Error as error:
        return Coverage(skipped=[f"{direction.protein}, {direction.name}: {error}"])
    return Coverage(rows)


def _nearest(judge: Judge, subject: Subject, one: Ensemble, frames: int, seed: int) -> Nearest:
    distances = judge.distances(one.draw(subject, frames, seed))
    return Nearest(
        judge.direction.kind,
        judge.direction.protein,
        judge.direction.name,
        len(judge.atoms),
        one.name,
        frames,
        judge.at_start,
        float(distances.min()),
        judge.limit,
    )


def _shares(rows: list[Nearest], kind: str, one: Ensemble, frames: int) -> list[Share]:
    """All distances first, then those of ``DISTANCES`` that occur."""
    rows = [r for r in rows if (r.kind, r.ensemble, r.frames) == (kind, one.name, frames)]
    found = [_share(rows, "all")]
    for low, high in DISTANCES:
        part = [row for row in rows if low <= row.at_start < high]
        if part:
            found.append(_share(part, f"{low:g}-{high:g}" if high < math.inf else f"{low:g} on"))
    return found


def _share(rows: list[Nearest], of_distance: str) -> Share:
    """Errors by bootstrap over proteins: both directions of one are not independent."""
    names = [row.protein for row in rows]
    proteins = [[k for k, n in enumerate(names) if n == name] for name in dict.fromkeys(names)]
    covered = np.array([float(row.is_covered) for row in rows])

    def figure(drawn: np.ndarray) -> list[float]:
        return [float(covered[np.concatenate([proteins[k] for k in drawn])].mean())]

    error = bootstrap(len(proteins), figure, DRAWS)[0] if len(proteins) > 1 else math.nan
    return Share(
        rows[0].kind,
        rows[0].ensemble,
        rows[0].frames,
        of_distance,
        len(rows),
        float(covered.mean()),
        float(error),
        float(np.mean([row.nearest for row in rows])),
    )
