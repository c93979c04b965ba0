# SPDX-License-Identifier: MIT
"""Measures coverage: frames from one structure of a pair alone, the nearest to the other."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from functools import partial
from pathlib import Path

import numpy as np

from pliant._core import Error
from pliant.lab.options import chosen
from pliant.lab.pairs.directions import COVERED, Direction, Judge, directions_of
from pliant.lab.pairs.ensembles import ENSEMBLES, Ensemble
from pliant.lab.pool import each_done
from pliant.lab.results import Cell, Results, print_table
from pliant.lab.structures import protein_model
from pliant.measure.agreement import bootstrap

DISTANCES = ((0.0, 5.0), (5.0, 8.0), (8.0, math.inf))  #: Angstrom between the two structures
DRAWS = 1000


@dataclass(frozen=True)
class Nearest:
    """One direction and one way to make frames."""

    kind: str
    protein: str
    direction: str
    residues: int  #: that both structures have
    ensemble: str
    frames: int
    at_start: float  #: distance of the start from the goal (Angstrom)
    nearest: float  #: of the nearest frame
    limit: float

    @property
    def is_covered(self) -> bool:
        """Whether a frame is nearer than the limit."""
        return self.nearest < self.limit


@dataclass(frozen=True)
class Share:
    """All directions of a kind, or those of some distance, for one way to make frames."""

    kind: str
    ensemble: str
    frames: int
    of_distance: str  #: "all", "0-5", ...
    directions: int
    covered: float  #: share
    error: float  #: of it, by bootstrap over proteins; nan for fewer than two
    nearest: float  #: mean (Angstrom)


SHARES: dict[str, Cell] = {
    "set": "kind",
    "distance, A": "of_distance",
    "directions": "directions",
    "frames": "frames",
    "ensemble": "ensemble",
    "covered": "covered:.3f",
    "+-": "error:.3f",
    "nearest, A": "nearest:.2f",
}


@dataclass
class Coverage(Results):
    """The whole table."""

    rows: list[Nearest] = field(default_factory=list)
    shares: list[Share] = field(default_factory=list)
    skipped: list[str] = field(default_factory=list)  #: directions that could not be measured, why

    def print_report(self) -> None:
        """A line a share; then what could not be measured."""
        limits = ", ".join(f"{kind} below {limit:g} A" for kind, limit in COVERED.items())
        print(
            f"share of directions in which a frame comes near the other structure: {limits};\n"
            "+-: standard error by bootstrap over proteins; nearest: mean distance of the nearest "
            "frame"
        )
        print_table(self.shares, SHARES)
        for line in self.skipped:
            print(f"not measured: {line}")


def coverage(
    folder: str | Path,
    ensembles: Sequence[str] = (),
    frames: Sequence[int] = (200, 1000),
    *,
    seed: int = 0,
    processes: int = 1,
    progress: Callable[[int, int], object] = lambda *_: None,
) -> Coverage:
    """All directions of a folder (see ``directions_of``); ensembles by name, all if none is given.

    Raises InputError where the folder holds no pair. A direction that cannot be measured is named
    in ``skipped``.
    """
    directions = directions_of(Path(folder))
    asked = chosen(ENSEMBLES, ensembles)
    work = partial(_of_direction, asked, frames, seed)
    found = Coverage()
    for done, part in enumerate(each_done(work, directions, processes), start=1):
        found.rows += part.rows
        found.skipped += part.skipped
        progress(done, len(directions))
    for kind in dict.fromkeys(row.kind for row in found.rows):
        for count in frames:
            for one in asked:
                found.shares += _shares(found.rows, kind, one.name, count)
    return found


def _of_direction(
    asked: list[Ensemble], frames: Sequence[int], seed: int, direction: Direction
) -> Coverage:
    """All ensembles of one direction, or the reason why there are none."""
    try:
        model = protein_model(direction.start)
        judge = Judge(direction, model.structure)

        def nearest(one: Ensemble, count: int) -> Nearest:
            distances = judge.distances(one.draw(model, count, seed))
            who = direction.kind, direction.protein, direction.name, len(judge.atoms)
            least = float(distances.min())
            return Nearest(*who, one.name, count, judge.at_start, least, judge.limit)

        return Coverage([nearest(one, count) for one in asked for count in frames])
    except Error as error:
        return Coverage(skipped=[f"{direction.protein}, {direction.name}: {error}"])


def _shares(rows: list[Nearest], kind: str, ensemble: str, frames: int) -> list[Share]:
    """All distances first, then those of ``DISTANCES`` that occur."""
    rows = [r for r in rows if (r.kind, r.ensemble, r.frames) == (kind, ensemble, frames)]
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
