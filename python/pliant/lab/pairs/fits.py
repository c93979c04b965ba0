# SPDX-License-Identifier: MIT
"""Measures fits: distances or a density map of the other structure of a pair, given to a fit of the
one."""

from __future__ import annotations

import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from functools import partial
from pathlib import Path

import numpy as np

from pliant._core import DensityData, DensityMap, Error, InputError, PathOptions
from pliant.jobs.fit import nodes as at_nodes
from pliant.jobs.fit.data import Datum
from pliant.jobs.fit.design import best_pairs, labelled
from pliant.jobs.fit.in_map import FLOOR
from pliant.jobs.fit.molecule import FRAMES, Molecule
from pliant.jobs.fit.saxs.explained import fit_curve
from pliant.lab.pairs.curves import curve_of
from pliant.lab.pairs.directions import Direction, Judge, directions_of
from pliant.lab.pairs.maps import noisy, without_half
from pliant.lab.pool import each_done
from pliant.lab.results import Cell, Results, print_table
from pliant.lab.structures import amino_part, quiet, read_quietly
from pliant.trajectory.superposition import superpose_onto

ERROR, OTHER_ERRORS = 1.0, (0.5, 3.0)  #: Angstrom
WRONG = 15.0
ANY = (0.0, np.inf)
COUNTS = (5, 10, 20)
RANDOM, MISTAKEN = "10 random", "10 designed, 1 wrong"
CURVE, NEAREST = "SAXS curve", "SAXS curve, best of the frames"
MAPS = (
    ("map of 5 A, noise of 1/4", 5.0, partial(noisy, share=0.25)),
    ("map of 5 A, noise of 1/2", 5.0, partial(noisy, share=0.5)),
    ("map of 8 A", 8.0, lambda map, _: map),
    ("map of 8 A, half of it missing", 8.0, lambda map, _: without_half(map)),
    ("map of 12 A", 12.0, lambda map, _: map),
)
LIMITS = (3.0, 2.0)  #: Angstrom
APART = 8  #: more residues between two that are drawn


@dataclass(frozen=True)
class Fit:
    """One direction, one set of data."""

    protein: str
    direction: str
    residues: int
    data: str
    at_start: float  #: r.m.s. distance of alpha carbons from the goal (Angstrom)
    reached: float
    within: float | None  #: share of residues whose error is at most twice their spread
    named: bool  #: the wrong one was let go, and no other; where none is wrong, none was
    seconds: float


@dataclass(frozen=True)
class Share:
    """All directions, one set of data."""

    data: str
    directions: int
    at_start: float
    reached: float
    median: float
    below_3: float
    below_2: float
    within: float | None
    named: int
    seconds: float


SHARES: dict[str, Cell] = {
    "data": "data",
    "directions": "directions",
    "at first, A": "at_start:.2f",
    "reached, A": "reached:.2f",
    "median, A": "median:.2f",
    "below 3 A": "below_3:.2f",
    "below 2 A": "below_2:.2f",
    "error within 2 spreads": "within:.2f",
    "rightly named": "named",
    "s": "seconds:.1f",
}


@dataclass
class Fits(Results):
    """The whole table."""

    rows: list[Fit] = field(default_factory=list)
    shares: list[Share] = field(default_factory=list)
    skipped: list[str] = field(default_factory=list)

    def print_report(self) -> None:
        """A line a set of distances; then what could not be measured."""
        print("r.m.s. distance of alpha carbons from the other structure, which the data are from")
        print_table(self.shares, SHARES)
        for line in self.skipped:
            print(f"not measured: {line}")


def fits(
    folder: str | Path,
    residues: int = 350,
    *,
    seed: int = 0,
    processes: int = 1,
    progress: Callable[[int, int], object] = lambda *_: None,
) -> Fits:
    """All directions of a folder (see ``directions_of``) of at most so many residues."""
    directions = directions_of(Path(folder))
    work = partial(_of_direction, residues, seed)
    found = Fits()
    for done, part in enumerate(each_done(work, directions, processes), start=1):
        found.rows += part.rows
        found.skipped += part.skipped
        progress(done, len(directions))
    for data in dict.fromkeys(row.data for row in found.rows):
        found.shares.append(_share([row for row in found.rows if row.data == data]))
    return found


def _share(rows: Sequence[Fit]) -> Share:
    reached = np.array([row.reached for row in rows])
    return Share(
        data=rows[0].data,
        directions=len(rows),
        at_start=float(np.mean([row.at_start for row in rows])),
        reached=float(reached.mean()),
        median=float(np.median(reached)),
        below_3=float((reached < LIMITS[0]).mean()),
        below_2=float((reached < LIMITS[1]).mean()),
        within=_mean([row.within for row in rows]),
        named=sum(row.named for row in rows),
        seconds=float(np.mean([row.seconds for row in rows])),
    )


def _of_direction(residues: int, seed: int, direction: Direction) -> Fits:
    try:
        with quiet():
            return Fits(_Case(residues, seed, direction).rows())
    except Error as error:
        return Fits(skipped=[f"{direction.protein}, {direction.name}: {error}"])


class _Case:
    """A start with its ensemble, and the goal."""

    def __init__(self, residues: int, seed: int, direction: Direction) -> None:
        start = amino_part(read_quietly(direction.start))
        self.begun = time.perf_counter()
        self.direction = direction
        self.molecule = Molecule(start, seed, PathOptions())
        if len(self.molecule.atoms) > residues:
            raise InputError(f"more than {residues} residues")
        self.molecule.sampled(FRAMES)
        self.sampled = time.perf_counter() - self.begun
        self.of = self.molecule.ensemble
        judge = Judge(direction, self.molecule.model.structure)
        node = {int(atom): k for k, atom in enumerate(self.molecule.atoms)}
        self.shared = np.array([node[int(atoms[1])] for atoms in judge.atoms])
        self.goal = judge.goal[:, 1]
        self.seed = seed
        self.random = np.random.default_rng(seed)

    def rows(self) -> list[Fit]:
        shared = set(self.shared.tolist())
        sites = [k for k in labelled(self.molecule, "any", ()) if k in shared]
        made = best_pairs(self.of.frames, sites, COUNTS[-1], ANY, gained=0.0)
        pairs = [one.pair for one in made]
        found = [row for k in COUNTS for row in self.to(f"{k} designed", self.data(pairs[:k]))]
        for error in OTHER_ERRORS:
            found += self.to(f"10 designed, +-{error:g} A", self.data(pairs[:10], error=error))
        found += self.to(RANDOM, self.data(self.drawn()))
        wrong = int(self.random.integers(min(10, len(pairs))))
        found += self.to(MISTAKEN, self.data(pairs[:10], wrong), wrong)
        return [*found, *self.to_curve(), *self.to_maps()]

    def to_curve(self) -> list[Fit]:
        """Of the other structure; the frame that explains it, and the one that is nearest to it."""
        begun = time.perf_counter()
        molecule, goal = self.molecule, amino_part(read_quietly(self.direction.goal))
        curve = curve_of(goal, self.seed)
        fit = fit_curve(curve, molecule.model, molecule.frames, molecule.atoms, seed=self.seed)
        found = fit.positions[0][molecule.atoms]
        nearest = min(self.of.frames, key=lambda frame: _rms(self.apart(frame)))
        rows = ((CURVE, found), (NEAREST, nearest))
        return [self.fit(name, nodes, None, True, begun) for name, nodes in rows]

    def to_maps(self) -> list[Fit]:
        """Of all atoms of the other structure; the start is superposed on it."""
        goal = amino_part(read_quietly(self.direction.goal))
        start = superpose_onto(self.of.start[None], self.shared, self.goal)[0]
        frames = np.ascontiguousarray(superpose_onto(self.of.frames, slice(None), start))
        self.of = at_nodes.Ensemble(start, frames, self.of.chains)
        found = []
        for name, resolution, change in MAPS:
            density = change(DensityMap.from_structure(goal, resolution), resolution)
            data = DensityData(density, resolution, self.molecule.structure, frames)
            floor = FLOOR * resolution
            found += self.fits_to(name, at_nodes.Known([], data), None, floor)
        return found

    def to(self, name: str, data: list[Datum], wrong: int | None = None) -> list[Fit]:
        return self.fits_to(name, at_nodes.Known(data), wrong)

    def fits_to(
        self, name: str, data: at_nodes.Known, wrong: int | None, floor: float = 0.0
    ) -> list[Fit]:
        """At the nodes, and with all atoms."""
        begun = time.perf_counter()
        known = at_nodes.consistent(self.of, data)
        spread = np.hypot(known.fits.spread, floor)
        rows = [self.row(name, known, known.fits.positions[0], spread, wrong, begun)]
        atoms = self.molecule.brought(known.fits, 0).positions[self.molecule.atoms]
        return [*rows, self.row(f"{name}, all atoms", known, atoms, spread, wrong, begun)]

    def row(
        self,
        name: str,
        known: at_nodes.Consistent,
        nodes: np.ndarray,
        spread: np.ndarray,
        wrong: int | None,
        begun: float,
    ) -> Fit:
        within = (self.apart(nodes) <= 2 * spread[self.shared]).mean()
        named = known.contradicting == ([] if wrong is None else [wrong])
        return self.fit(name, nodes, float(within), named, begun)

    def fit(
        self, name: str, nodes: np.ndarray, within: float | None, named: bool, begun: float
    ) -> Fit:
        return Fit(
            protein=self.direction.protein,
            direction=self.direction.name,
            residues=len(self.shared),
            data=name,
            at_start=_rms(self.apart(self.of.start)),
            reached=_rms(self.apart(nodes)),
            within=within,
            named=named,
            seconds=self.sampled + time.perf_counter() - begun,
        )

    def apart(self, nodes: np.ndarray) -> np.ndarray:
        """How far each residue is from where it is in the goal, superposed."""
        moved = superpose_onto(nodes[self.shared][None], slice(None), self.goal)[0]
        return np.asarray(np.linalg.norm(moved - self.goal, axis=1))

    def drawn(self) -> list[tuple[int, int]]:
        pairs: list[tuple[int, int]] = []
        while len(pairs) < COUNTS[1]:
            one, other = sorted(self.random.choice(self.shared, 2, replace=False).tolist())
            if other - one > APART:
                pairs.append((one, other))
        return pairs

    def data(
        self, pairs: Sequence[tuple[int, int]], wrong: int | None = None, error: float = ERROR
    ) -> list[Datum]:
        place = {int(node): k for k, node in enumerate(self.shared)}
        found = []
        for k, (one, other) in enumerate(pairs):
            middle = float(np.linalg.norm(self.goal[place[one]] - self.goal[place[other]]))
            if k == wrong:
                middle += WRONG if middle < WRONG + 4 or self.random.random() < 0.5 else -WRONG
            found.append(Datum(str(k), (one, other), max(0.0, middle - error), middle + error))
        return found


def _rms(lengths: np.ndarray) -> float:
    return float(np.sqrt((lengths**2).mean()))


def _mean(shares: Sequence[float | None]) -> float | None:
    known = [share for share in shares if share is not None]
    return float(np.mean(known)) if known else None
