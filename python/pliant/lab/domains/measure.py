# SPDX-License-Identifier: MIT
"""Measures domains: reported by several seeds of one structure alone, against those of the pair."""

from __future__ import annotations

import math
import warnings
from collections.abc import Callable, Iterable, Sequence
from concurrent.futures import ProcessPoolExecutor
from dataclasses import asdict, dataclass, field
from pathlib import Path
from typing import Any

import numpy as np

import pliant
from pliant._core import Error, Structure
from pliant.lab.coverage.directions import DOMAIN, Direction, Judge, directions_of
from pliant.lab.coverage.ensembles import Subject
from pliant.lab.domains.agreement import agreement, contradicted, found
from pliant.lab.domains.pair_domains import pair_domains
from pliant.lab.validity.alpha_carbons import trace_of
from pliant.measure.domains import Domains, find_domains
from pliant.measure.stages.biology import MOST_DOMAIN_SITES
from pliant.trajectory.superposition import superpose_all


@dataclass(frozen=True)
class Row:
    """One structure, its ensembles of some seeds, and the other structure where it is known."""

    protein: str
    structure: str
    residues: int
    numbers: list[int]  #: of domains reported, of each seed; 0: they do not repeat
    contradicted: int  #: pairs of residues, over all pairs of seeds
    pair: int | None = None  #: domains of the known pair
    agreement: float = math.nan  #: with these, mean of the seeds that report two or more
    worst: float = math.nan  #: of these seeds
    found: list[int] = field(default_factory=list)  #: seeds that report each domain of the pair

    @property
    def is_shown(self) -> bool:
        """Whether more than half of the seeds report two domains or more."""
        return 2 * sum(number > 1 for number in self.numbers) > len(self.numbers)


@dataclass
class Table:
    """All structures."""

    rows: list[Row] = field(default_factory=list)
    skipped: list[str] = field(default_factory=list)  #: structures that could not be measured, why

    def as_json(self) -> dict[str, Any]:
        """For --json."""
        return asdict(self)


def domains(
    folder: str | Path,
    seeds: int = 10,
    frames: int = 200,
    also: Sequence[str] = (),
    *,
    processes: int = 1,
    progress: Callable[[int, int], object] | None = None,
) -> Table:
    """Both structures of each pair of domain motions in a folder, and some structures alone.

    Raises InputError where the folder holds no pair.
    """
    pairs = [one for one in directions_of(Path(folder)) if one.kind == DOMAIN]
    alone = [Direction(Path(path).stem, Path(path), Path(path)) for path in also]
    every, table = [*pairs, *alone], Table()
    for done, part in enumerate(_each(every, seeds, frames, processes), start=1):
        table.rows += part.rows
        table.skipped += part.skipped
        if progress:
            progress(done, len(every))
    return table


def _each(every: list[Direction], seeds: int, frames: int, processes: int) -> Iterable[Table]:
    if processes == 1:
        return (_of_one(one, seeds, frames) for one in every)
    pool = ProcessPoolExecutor(processes)
    return pool.map(_of_one, every, [seeds] * len(every), [frames] * len(every))


def _of_one(direction: Direction, seeds: int, frames: int) -> Table:
    """One structure, or the reason why it could not be measured."""
    try:
        return Table([_row(direction, seeds, frames)])
    except Error as error:
        return Table(skipped=[f"{direction.protein}, {direction.start.stem}: {error}"])


def _row(direction: Direction, seeds: int, frames: int) -> Row:
    model = Subject.of(direction.start).model
    trace = trace_of(model.structure).atoms
    reported = [_domains(model, trace, frames, seed) for seed in range(seeds)]
    row = Row(
        direction.protein,
        direction.start.stem,
        len(trace),
        [int(one.max()) + 1 for one in reported],
        contradicted(reported),
    )
    return row if direction.start == direction.goal else _compared(row, direction, model, reported)


def _domains(model: pliant.MolecularModel, trace: np.ndarray, frames: int, seed: int) -> np.ndarray:
    """(n,) domain of each residue, as pliant analyse reports it."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", pliant.PliantWarning)
        made = pliant.sample(model, frames, sampler="modes", seed=seed)
    positions = superpose_all(np.asarray(made.positions)[:, trace])
    stride = -(-len(trace) // MOST_DOMAIN_SITES)
    chains = _chains(model.structure, trace)
    found: Domains = find_domains(positions[:, ::stride], chains[::stride])
    return np.repeat(found.domain, stride)[: len(trace)]


def _chains(structure: Structure, trace: np.ndarray) -> np.ndarray:
    return np.asarray(np.unique(np.asarray(structure.chains)[trace], return_inverse=True)[1])


def _compared(
    row: Row, direction: Direction, model: pliant.MolecularModel, reported: list[np.ndarray]
) -> Row:
    """The row with what the known pair says of residues that both structures have."""
    judge = Judge(direction, model.structure)
    start = np.asarray(model.structure.positions)[judge.atoms]
    numbers = np.asarray(model.structure.residue_ids)[judge.atoms[:, 1]]
    known = pair_domains(start[:, :3], judge.goal[:, :3], numbers)
    places = {int(atom): k for k, atom in enumerate(trace_of(model.structure).atoms)}
    shared = [places[int(atom)] for atom in judge.atoms[:, 1]]
    parts = [one[shared] for one in reported]
    agreed = [agreement(one, known) for one in parts if one.max() > 0] or [math.nan]
    return Row(
        row.protein,
        row.structure,
        row.residues,
        row.numbers,
        row.contradicted,
        int(known.max()) + 1,
        float(np.mean(agreed)),
        min(agreed),
        np.sum([found(one, known) for one in parts], axis=0).tolist(),
    )
